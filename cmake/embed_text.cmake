# cmake -DINPUT=FILE -DHEADER=FILE -DFUNCTION=NAME -DOUTPUT=FILE -P embed_text.cmake: the bytes of a file as a C++ source,
# which defines `std::span<const std::string_view> NAME()` as HEADER declares it. In pieces, since compilers limit the
# length of a literal.
file(READ ${INPUT} hexadecimal HEX)
string(LENGTH "${hexadecimal}" length)
set(piece_digits 16000)
set(pieces "")
set(start 0)
while(start LESS length)
  string(SUBSTRING "${hexadecimal}" ${start} ${piece_digits} digits)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${digits}")
  string(LENGTH "${digits}" count)
  math(EXPR count "${count} / 2")
  string(APPEND pieces "    {\"${bytes}\", ${count}},\n")
  math(EXPR start "${start} + ${piece_digits}")
endwhile()
file(WRITE ${OUTPUT} "// Made from ${INPUT} at build time.
#include <${HEADER}>

#include <array>

namespace {
constexpr std::array pieces = std::to_array<std::string_view>({
${pieces}});
}

std::span<const std::string_view> ${FUNCTION}() { return pieces; }
")
