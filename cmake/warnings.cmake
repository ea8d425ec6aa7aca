# Warnings for our own targets only; the presets turn them into errors.
add_library(orispline_warnings INTERFACE)
target_compile_options(orispline_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion)
