# SPDX-License-Identifier: Apache-2.0
# Every target does the set-up that it needs.
JOBS ?= $(shell nproc 2>/dev/null || echo 2)

.PHONY: run build wasm test test-more python check clang sanitizers asan ubsan tsan coverage fuzz nightly mutants random release release-parts sweep bench bench-quick bench-python bench-fusion bench-web measures site page studio web deb format tidy clean
.NOTPARALLEL:

# How long the parts of `make test` take, in build/times.tsv: $(call timed,PART) COMMAND.
times = build/times.tsv
timed = tools/timed.py $(times) "$(1)"

define build_and_test
	cmake --preset $(1)
	cmake --build --preset $(1) -j $(JOBS)
	ctest --preset $(1) -j $(JOBS)
endef

run: build
	examples/demo.sh build/release/orispline build/run

build:
	tools/setup.sh build
	@tools/timed.py $(times) --begin
	cmake --preset release
	$(call timed,the release) cmake --build --preset release -j $(JOBS)

# The library for WebAssembly with the programs that test it; where its compiler is not to be had, their tests say so.
build_wasm = $(call timed,the library for WebAssembly) tools/build_wasm.sh -j $(JOBS)

wasm:
	tools/setup.sh build wasm
	tools/timed.py $(times) --begin
	$(build_wasm)

# The Python package from the release, of which only the module is compiled; the wheel in build/python/dist is tested.
python_package = cmake --install build/release --prefix build/python/prefix > /dev/null && \
  python3 bindings/python/build.py build/python build/python/prefix $(1)

# One build of the library serves the command, the tests, the users' programs and the Python package, which is built where Python's
# headers and the packages of its tests are to be had. That and the site are tests of ctest too, since much of them takes one core only, so
# that others run beside them. The studio comes before the command that holds its page.
test: build
	tools/setup.sh build test python spark wasm site
	$(build_wasm)
	$(build_studio)
	cmake --preset release -DORISPLINE_TESTS=ON
	$(call timed,the tests' build) cmake --build build/release -j $(JOBS)
	$(call timed,the tests) ctest --preset release -j $(JOBS) --output-junit junit.xml --test-output-size-passed 100000
	@tests/summary.py build/release/junit.xml
	@tools/timed.py $(times) --table

# What is too long for `make test`, or wants a machine that does nothing else: other compilers and standards, the library as
# a part of other builds; then, one by one, what is measured by the clock.
test-more: test
	ctest --preset release-more -j $(JOBS)
	ctest --preset release-timing
	$(call python_package,--timing --oldest --or-skip)

# The wheel and the source of the Python package in build/python/dist, tested in an environment of its own.
python: build
	tools/setup.sh build python spark
	$(call python_package,--sdist --test)

# The Python package beside SciPy, by processor time; fills its tables in docs/benchmarks.md and docs/scale.md.
bench-python: build
	tools/setup.sh build python spark
	$(call python_package,)
	build/python/venv/bin/python benchmarks/python/run.py --document docs/benchmarks.md
	build/python/venv/bin/python benchmarks/python/many_tracks.py --document docs/scale.md

# The clips to which noise that correlates is added; those that the project may not hold, where they lie beside it.
NOISY_CLIPS = examples/data/walking.bvh $(wildcard ../shared/cases/clips/20_mocap_true.bvh) \
  $(foreach part,300:500 1100:500 1900:500,$(addsuffix :$(part),$(wildcard ../shared/data/mocap/cmu_01_01_fairmotion.bvh)))

# A gyro beside the least error that is possible, and VQF, and clips beside the best low-pass; fills the tables of docs/gyro.md,
# docs/smooth.md and docs/skeletons.md. Two hours of one core.
bench-fusion: build
	tools/setup.sh build python
	python3 -m venv build/fusion/venv
	build/fusion/venv/bin/python -m pip install --quiet numpy scipy vqf
	build/fusion/venv/bin/python benchmarks/fusion/run.py build/release/orispline --jobs $(JOBS) --document docs/gyro.md
	build/fusion/venv/bin/python benchmarks/fusion/on_clips.py build/release/orispline $(NOISY_CLIPS) --document docs/smooth.md
	build/fusion/venv/bin/python benchmarks/fusion/cleaned_clips.py build/release/orispline $(NOISY_CLIPS) --jobs $(JOBS) --document docs/skeletons.md

# Each part that passes leaves the stamp that a release of this commit asks for; a part that has it is not run again.
check:
	@set -e; for part in $$(tools/release.py unchecked); do $(MAKE) $$part; tools/release.py stamp $$part; done

clang sanitizers tsan:
	tools/setup.sh build test check
	$(call build_and_test,$@)

asan ubsan: sanitizers

# Fails when the tests run less than 95 % of the lines of src/.
coverage:
	tools/setup.sh build test check
	rm -rf build/coverage
	$(call build_and_test,coverage)
	gcovr --root . --filter src/ --txt build/coverage/lines.txt --print-summary --fail-under-line 95 build/coverage

# Every target so many seconds, under sanitizers; docs/fuzzing.md tells what to do with what it finds.
fuzz: SECONDS ?= 60
fuzz:
	tools/setup.sh build check
	cmake --preset fuzz
	cmake --build --preset fuzz -j $(JOBS)
	tests/fuzz/run.py build/fuzz/tests/fuzz $(SECONDS) --jobs $(JOBS)

# The source of the Python package, in an environment with nothing but pip.
define from_source
	rm -rf build/alone && python3 -m venv build/alone
	build/alone/bin/python -m pip install --quiet --no-cache-dir $(1)/orispline-*.tar.gz
	cd build/alone && bin/orispline --version && bin/python -c 'import orispline; print(orispline.__version__)'
endef

# What is too long for every change; docs/testing.md tells what each part finds. Ten minutes a target are an hour of fuzzing.
nightly: check test-more coverage random sweep
	$(MAKE) fuzz SECONDS=600
	$(MAKE) mutants
	$(MAKE) tidy
	rm -rf build/twice
	tools/release.py twice build/twice
	tools/abi.py compare build/twice/one/build/deb
	$(call from_source,build/twice/one/build/python/dist)

# The properties, each on many random cases from a seed that is new every time; it is printed to have them again.
random: CASES = 5000
random: SEED := $(shell od -An -N4 -tu4 /dev/urandom | tr -d ' ')
random:
	tools/setup.sh build test
	cmake --preset release -DORISPLINE_TESTS=ON
	cmake --build build/release -j $(JOBS) --target contract_tests batch_tests
	RC_PARAMS="seed=$(SEED) max_success=$(CASES) max_size=60" \
	  ctest --test-dir build/release -R '^(contract|batch)_tests\.' -j $(JOBS) --output-on-failure

# Every orientation track of the recordings beside the project, with noise, is smoothed: it may not become worse.
sweep:
	tools/setup.sh build test
	cmake --preset release -DORISPLINE_TESTS=ON
	cmake --build build/release -j $(JOBS) --target smooth_tests
	ORISPLINE_SWEEP=all GTEST_FILTER='NeverWorse.*:Strikes.*:Adaptation.*:Gyro*' \
	  ctest --test-dir build/release -R '^smooth_tests\.[01]$$' -j $(JOBS) --output-on-failure

# Small faults in the library, and whether the tests find them: hours.
mutants:
	tools/setup.sh build test
	tools/mutate.py --jobs $(JOBS)

# Speed beside the peers; both write build/bench/ratios.json. Best on a machine that does nothing else.
define build_and_measure
	tools/setup.sh build bench
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)
	benchmarks/run.py build/bench/benchmarks/orispline_bench build/bench $(1)
endef

# Fills docs/benchmarks.md too.
bench:
	$(call build_and_measure,--sizes full --document docs/benchmarks.md)

bench-quick:
	$(call build_and_measure,--sizes quick)

# The tables of the documents that are measured on many keys, beside Ruckig and, where they lie beside the project, on recordings: hours.
measures: build
	tools/setup.sh build python
	$(call python_package,)
	build/python/venv/bin/python -m pip install --quiet ruckig
	@set -e; for measure in limits retiming $(if $(wildcard ../shared/data),band smoothing fidelity); do \
	  build/python/venv/bin/python tools/measure.py $$measure build/release/orispline; done

# The npm package in build/npm, with the modules where their compiler is to be had.
npm_package = tools/build_wasm.sh -j $(JOBS) --target orispline_npm && \
  bindings/npm/build.sh build/release/orispline build/wasm/bindings/npm $(CURDIR)/build/npm-work $(CURDIR)/build/npm

# How long a choice on the page of all methods takes, beside the page of an earlier template, which a short history may lack.
# Then the npm package beside the native library and three.js, and the studio while a key is dragged; fills their tables in docs/benchmarks.md.
bench-web: build
	tools/setup.sh build test wasm
	rm -rf $(addprefix build/bench-web/,studio/report studio/viewer studio/editor bindings benchmarks earlier.html)
	tests/npm_ci.sh $(CURDIR)/studio $(CURDIR)/build/bench-web/studio
	mkdir -p build/bench-web/benchmarks build/bench-web/bindings/npm
	cp -R studio/report studio/viewer studio/editor studio/pages.js build/bench-web/studio
	cp -R benchmarks/web build/bench-web/benchmarks
	cp -R bindings/npm/src build/bench-web/bindings/npm
	build/release/orispline compare examples/data/flight_truth.csv --keep-every 8 --report build/bench-web/page.html > /dev/null
	git show 5da2fce2:src/orispline/report/page_template.html > build/bench-web/earlier.html 2> /dev/null || rm build/bench-web/earlier.html
	node build/bench-web/benchmarks/web/choosing.mjs build/bench-web/page.html $$(ls build/bench-web/earlier.html 2> /dev/null)
	$(npm_package)
	c++ -std=c++20 -O2 -Ibindings/c benchmarks/web/native.cpp -o build/bench-web/native -Lbuild/release/bindings/c -lorispline_c -Wl,-rpath,$(CURDIR)/build/release/bindings/c
	tools/build_studio.sh -j $(JOBS)
	ORISPLINE_STUDIO_WASM=$(CURDIR)/build/wasm/bindings/npm/studio/studio.wasm benchmarks/web/run.py build/npm build/npm-work/node_modules build/bench-web/native build/studio/studio.html build/bench-web/benchmarks/web/studio.mjs --document docs/benchmarks.md

# All pages and the references of Python, C++ and C as one site in build/site, which wants no network.
site = tools/site/make.py build/python/venv/bin/python build/python/prefix/include build/site

site: build
	tools/setup.sh build python site
	$(call python_package,)
	$(site)

# Builds the page of the reports anew, with the module that notebooks load too; it is part of the library.
page:
	tools/setup.sh build test
	tests/page/prepare.sh $(CURDIR)/studio $(CURDIR)/build/page/studio
	cp build/page/studio/report/dist/index.html src/orispline/report/page_template.html

# The studio: build/studio/studio.html, which the command holds once it is built again, and build/studio/site for hosts of files.
build_studio = $(call timed,the studio) tools/build_studio.sh -j $(JOBS)

studio:
	tools/setup.sh build test wasm
	tools/timed.py $(times) --begin
	$(build_studio)

# The npm package, ready for `npm pack`, and its tests.
web: build
	tools/setup.sh build test wasm
	$(npm_package)
	cmake --preset release -DORISPLINE_TESTS=ON
	ctest --preset release -R '^npm' --output-on-failure

# The Debian packages in build/deb, compiled by dpkg-buildpackage in a copy of the source.
deb:
	tools/setup.sh build deb test wasm
	$(build_studio)
	tools/make_deb.py build/deb --jobs $(JOBS)

# make release VERSION=0.2.0 [OUT=FOLDER]; docs/releasing.md tells what it asks for and how it is signed.
release:
	@tools/release.py make "$(VERSION)" $(if $(OUT),"$(OUT)")

# What a release is made of, but for its sources.
release-parts: build
	tools/setup.sh build python wasm deb
	$(build_studio)
	cmake --build --preset release -j $(JOBS)
	$(call python_package,--sdist)
	$(npm_package)
	$(MAKE) deb

format:
	tools/setup.sh test
	tools/format.sh

tidy:
	tools/setup.sh build test tidy
	cmake --preset clang -B build/tidy
	run-clang-tidy-22 -quiet -j $(JOBS) -extra-arg=-Wno-deprecated-declarations -p build/tidy '/(src|cli|papers|tests)/.*\.cpp$$|\.units/'

clean:
	rm -rf build
