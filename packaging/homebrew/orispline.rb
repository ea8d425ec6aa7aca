# SPDX-License-Identifier: Apache-2.0
# Not run: no Homebrew was to be had. A test holds it to the version and the dependencies; tools/recipes.py fills in the archive.
class Orispline < Formula
  desc "Smooth orientation curves through keyframes"
  homepage "@REPOSITORY@"
  url "@ARCHIVE@"
  version "0.3.0"
  sha256 "@SHA256@"
  license "Apache-2.0"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "fast_float" => :build
  depends_on "fmt" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "eigen"
  depends_on "tl-expected"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DBUILD_SHARED_LIBS=ON", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
    generate_completions_from_executable(bin/"orispline", "completion")
  end

  test do
    (testpath/"keys.csv").write "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0,0,0.6\n2,0.6,0,0,0.8\n"
    assert_match "t,qw", shell_output("#{bin}/orispline sample keys.csv --count 5")
  end
end
