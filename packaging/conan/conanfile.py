# SPDX-License-Identifier: Apache-2.0
# Exported by `conan export`, but not built: no server with its dependencies was to be had. tools/recipes.py fills conandata.yml.
from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get


class Orispline(ConanFile):
    name = "orispline"
    version = "0.3.0"
    description = "Smooth orientation curves through keyframes"
    license = "Apache-2.0"
    topics = ("quaternion", "rotation", "interpolation", "spline")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False], "io": [True, False], "optimise": [True, False], "cli": [True, False]}
    default_options = {"shared": False, "fPIC": True, "io": True, "optimise": True, "cli": False}
    implements = ["auto_shared_fpic"]

    def layout(self):
        cmake_layout(self, src_folder="src")

    def requirements(self):
        self.requires("eigen/[>=3.4 <4]", transitive_headers=True)
        self.requires("tl-expected/[>=1.0 <2]", transitive_headers=True)
        self.requires("fmt/[>=9.1 <12]")
        if self.options.io:
            self.requires("fast_float/[>=3.4 <9]")
            self.requires("nlohmann_json/[>=3.11 <4]")
        if self.options.cli:
            self.requires("cli11/[>=2.1 <3]")

    def validate(self):
        check_min_cppstd(self, 20)

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25 <5]")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for option in ("io", "optimise", "cli"):
            toolchain.cache_variables[f"ORISPLINE_{option.upper()}"] = bool(self.options.get_safe(option))
        toolchain.cache_variables["ORISPLINE_C"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        for name in ("LICENSE", "NOTICE", "THIRD_PARTY"):
            copy(self, name, self.source_folder, f"{self.package_folder}/licenses")

    def package_info(self):
        # Components and the alignment of Eigen's types are stated once, in the CMake package that is installed.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/orispline"]
