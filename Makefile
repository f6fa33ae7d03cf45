# Two commands suffice: `make demo` and `make test`. Both install what is missing (Debian packages)
# and wrap the CMake presets, which a C++ developer can use directly.

SHELL       := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := build

JOBS         ?= $(shell nproc)
MINUTES      ?= 30
CLANG_FORMAT ?= clang-format-14
# Precompiled headers, which a developer who uses the presets goes without.
CONFIGURE    := cmake -DCIRCUMSPECT_QUICK_BUILD=ON
COMMAND      := build/release/bin/circumspect
VERIFIED     := $(CURDIR)/build/proofs/circumspect-verified
FUZZ_TARGETS := $(wildcard fuzz/targets/*_fuzz.cpp)
SOURCES      := python3 tidy/tidy.py --list '*.hpp' '*.cpp'
export PYTHONDONTWRITEBYTECODE := 1

# The same random inputs on every run of `make test`, unless RC_PARAMS=... says otherwise: a quarter of those that
# a property names. `make soak` tries all of them, round after round.
TEST_RC_PARAMS := $(or $(RC_PARAMS),seed=20260101)
TEST_ONE_INPUT := CIRCUMSPECT_ONE_INPUT_IN=$(or $(CIRCUMSPECT_ONE_INPUT_IN),4)

.PHONY: build verified demo build-demo docs page proofs check test test-style test-packages test-proofs test-release \
        test-sanitize test-sanitize-beside build-release build-sanitize soak soak-sanitize soak-fuzz build-fuzz-fuzz build-fuzz-sanitize soak-hunt mutants mutants-generated tsan \
        coverage bench bench-goals format clean deb dist fresh-root ports windows wheel wheel-root rust release web npm web-soak deps deps-build deps-docs deps-proofs deps-verified deps-test \
        deps-deb deps-bench deps-web

deps: ; @cmake/packages.sh build demo proofs test browser bench web
deps-build: ; @cmake/packages.sh build
deps-docs: ; @cmake/packages.sh docs
deps-proofs: ; @cmake/packages.sh proofs
deps-verified: ; @cmake/packages.sh verified
deps-test: ; @cmake/packages.sh build proofs test browser
deps-deb: ; @cmake/packages.sh build deb
deps-bench: ; @cmake/packages.sh build bench
deps-web: ; @cmake/packages.sh build web

# The command, and what `cmake --install` installs. A first build leaves the tests out; a build that has them
# keeps them, so that going back and forth between `make` and `make test` compiles nothing twice.
build: deps-build
	@test -f build/release/build.ninja || $(CONFIGURE) --preset release -DCIRCUMSPECT_BUILD_TESTS=OFF
	@cmake --build --preset release --target circumspect_cli circumspect_archive -j $(JOBS)

# The checker of certificates, extracted from its Coq proof: of the proof, only what the program is made of is compiled, in ten
# seconds. Where it is found, `cmake --install` installs it beside the command.
verified: deps-verified
	@$(MAKE) --no-print-directory -C proofs -j $(JOBS) $(VERIFIED)
	@echo "built $(VERIFIED)"

# Each step before the demonstration prints one line; a log has the rest. The demonstration judges small meshes, so
# its command is built in half the time: by Clang, which does not optimize it, in a folder of its own.
demo:
	@rm -f build/demo.log
	@cmake/logged.sh build/demo.log "Installing the Debian packages that are missing" cmake/packages.sh demo
	@cmake/logged.sh build/demo.log "Compiling, two minutes the first time" $(MAKE) --no-print-directory build-demo
	@rm -rf build/demo-campaign
	@CIRCUMSPECT=build/demo/bin/circumspect CAMPAIGN_OUTPUT=build/demo-campaign bash corpus/demo.sh
build-demo:
	@$(CONFIGURE) --preset demo
	@cmake --build --preset demo -j $(JOBS)

# The site of docs/, in build/site: every page is in its menu, every link leads somewhere. The command draws pictures for it.
docs: deps-docs build
	@python3 tidy/links.py
	@mkdocs --quiet build --strict
	@echo "built $(CURDIR)/build/site/index.html"

# What `--html` puts its data into, bundled anew after a change in oracle/picture/page, and the images of docs/.
page: deps-test
	@oracle/picture/page/modules.sh build/release/page
	@NODE_PATH=build/release/page/node_modules node oracle/picture/page/bundle.mjs oracle/picture/page/page.built.html
	@$(MAKE) --no-print-directory build
	@oracle/picture/page/images.sh $(COMMAND) docs/images
	@echo "built oracle/picture/page/page.built.html and docs/images"

# The command as a page that runs in any browser, build/web/index.html, and its test; `web-soak` tries the whole corpus.
web web-soak: deps-web
	@JOBS=$(JOBS) command/web/build.sh build/web
	@NODE_PATH=build/web/modules/node_modules node command/web/web_test.mjs build/web $(if $(filter web-soak,$@),--all)
	@echo "built $(CURDIR)/build/web/index.html"

# The package for npm, and its tests: as its users ask it, in a project that installs it, and in Chromium.
npm: deps-web
	@JOBS=$(JOBS) js/build.sh build/web
	@js/test.sh build/web
	@echo "built $(CURDIR)/build/web/circumspect-oracle-*.tgz"

# The Python package as a wheel that needs nothing but Python and NumPy, with the command in it, and the archive of its
# sources, in build/wheel/dist; `wheel-root` installs the wheel into a bare Debian 13 and judges there.
wheel: deps-verified
	@cmake/packages.sh wheel
	@$(MAKE) --no-print-directory -C proofs -j $(JOBS) $(VERIFIED)-small
	@JOBS=$(JOBS) packaging/wheel.sh build/wheel $(VERIFIED)-small $(PYTHONS)
wheel-root:
	@packaging/wheel_root_test.sh build/wheel/dist

# The crate, tested against the C library, shared and as an archive.
rust:
	@cmake/packages.sh build rust
	@JOBS=$(JOBS) rust/make.sh build/rust

# All that a release consists of, with checksums, in build/published: docs/releasing.md.
release:
	@$(MAKE) --no-print-directory dist wheel
	@$(MAKE) --no-print-directory npm rust
	@$(MAKE) --no-print-directory deb
	@packaging/release.sh build/published

# Debian packages of the command, the libraries and the Python package, in build/deb; lintian looks at them.
deb: deps-deb
	@JOBS=$(JOBS) cmake/deb.sh build/deb

# The command as one file for any Linux, in an archive with its man pages and all licences, in build/dist. Where the
# sources lie is not in it.
dist: deps-build deps-verified
	@$(CONFIGURE) -S . -B build/static -G Ninja -DCMAKE_BUILD_TYPE=Release -DCIRCUMSPECT_BUILD_TESTS=OFF \
	  -DCIRCUMSPECT_STATIC=ON -DCMAKE_CXX_FLAGS=-ffile-prefix-map=$(CURDIR)=.
	@cmake --build build/static -j $(JOBS) --target circumspect_cli
	@$(MAKE) --no-print-directory -C proofs -j $(JOBS) $(VERIFIED)-static
	@cmake/dist.sh build/static build/dist $(VERIFIED)-static

# Installs both into a bare Debian 12 and judges there: for `make soak`.
fresh-root: deps-deb
	@debian/fresh_root_test.sh build/deb build/dist/circumspect-*-linux-*.tar.gz

# Builds in a bare Debian 13, judges the corpus there, and cross-compiles for arm64: for `make soak`.
ports:
	@cmake/packages.sh ports
	@JOBS=$(JOBS) cmake/ports.sh build/ports

# The command and the C library for Windows, by mingw-w64, which judge under wine.
windows:
	@cmake/packages.sh build windows
	@JOBS=$(JOBS) cmake/windows.sh build/windows

# The Coq proofs, and the program that is extracted from them.
proofs: deps-proofs
	@$(MAKE) --no-print-directory -C proofs -j $(JOBS) check
	@echo "built $(VERIFIED)"

# Those that `make test` leaves to the sanitizers too.
ALL_TESTS := -DCIRCUMSPECT_BUILD_TESTS=ON -DCIRCUMSPECT_LEAVE_TO_SANITIZERS=OFF
# Those that need what `deps-test` installs: a browser, and the ranks of MPI.
BROWSER_AND_RANKS := -DCIRCUMSPECT_CHROMIUM=/usr/bin/chromium -DCIRCUMSPECT_BUILD_MPI=ON

# What a developer runs while working: style, and the tests of what has changed since the last green run.
check: test-style
	@mkdir -p build
	@$(CONFIGURE) --preset release $(ALL_TESTS) >build/check.log || { cat build/check.log; exit 1; }
	@RC_PARAMS="$(TEST_RC_PARAMS)" $(TEST_ONE_INPUT) python3 tidy/check.py build/release --jobs $(JOBS)
	@python3 properties/generated_mutants.py --untried

# The proofs are compiled before the C++ sources: side by side, four compilers take turns on two processors and get in each
# other's way. What else is missing is fetched beside them. The sanitizers' build and its tests run beside the release's
# tests, which have times at which they keep one processor waiting.
test:
	@cmake/packages.sh proofs
	@$(MAKE) --no-print-directory -j 2 test-proofs test-packages
	@$(MAKE) --no-print-directory build-release
	@$(MAKE) --no-print-directory -j 2 test-release test-sanitize-beside
	@python3 tidy/check.py build/release --green
	@echo
	@echo "make test: everything passed"
	@echo "  layout and architecture   clang-format and tidy found nothing"
	@for preset in release sanitize; do \
	  printf '  %-24s  %s; %s\n' "$$preset" \
	    "$$(grep -h 'tests passed' build/$$preset/ctest.log)" \
	    "$$(awk '/^\[doctest\] test cases:/ { cases += $$4 } /^\[doctest\] assertions:/ { checks += $$3 } \
	             END { print cases + 0 " cases, " checks + 0 " assertions" }' \
	         build/$$preset/Testing/Temporary/LastTest.log)"; \
	done

test-packages:
	@cmake/packages.sh build test browser
	@$(MAKE) --no-print-directory test-style

test-style:
	@if command -v $(CLANG_FORMAT) >/dev/null; then $(SOURCES) | xargs -r -d '\n' $(CLANG_FORMAT) --dry-run -Werror || \
	    { echo "the layout differs from .clang-format: run 'make format'" >&2; exit 1; }; \
	  else echo "the layout is that of $(CLANG_FORMAT), which this release of Debian does not have: not checked"; fi
	@python3 tidy/tidy.py
	@python3 tidy/tidy_test.py
	@python3 tidy/links.py
	@python3 tidy/links_test.py
	@python3 tidy/check_test.py

# All but coqchk, and the filters' bounds that must be refused: these compile nothing and are slow. `make proofs` runs them.
test-proofs: deps-proofs
	@MAKEFLAGS= $(MAKE) --no-print-directory -C proofs -j $(JOBS) all holes filter-bounds mutants

# What it prints would stand between the lines of the release's tests.
test-sanitize-beside:
	@echo "the sanitizers' build and its tests run beside: build/sanitize.log"
	@$(MAKE) --no-print-directory RELEASE_IS_BUILT=1 test-sanitize >build/sanitize.log 2>&1 || \
	  { tail -n 100 build/sanitize.log; echo "the sanitizers' build or tests failed; all of it: build/sanitize.log" >&2; exit 1; }

# The sanitizers' build links the release's archives of what handles
# values alone. Clang compiles it in half the time when it does not optimize, which costs the tests less than that, and in a
# sixth less without line numbers: a failure names functions, and `make soak-sanitize` their lines.
SETTINGS_release  := $(BROWSER_AND_RANKS) -DCIRCUMSPECT_LEAVE_TO_SANITIZERS=ON
SETTINGS_sanitize := -DCIRCUMSPECT_SANITIZE_ALL=OFF -DCIRCUMSPECT_VALUES_FROM=$(CURDIR)/build/release \
                     -DCMAKE_CXX_FLAGS_DEBUG=-O0
# Beside the release's tests, it is not to be configured twice at once.
build-sanitize: $(if $(RELEASE_IS_BUILT),,build-release)
build-release build-sanitize: build-%:
	@$(CONFIGURE) --preset $* -DCIRCUMSPECT_BUILD_TESTS=ON -DCIRCUMSPECT_VERIFIED=$(VERIFIED) $(SETTINGS_$*)
	@cmake --build --preset $* -j $(JOBS) $(if $(filter sanitize,$*),--target circumspect_tests)

# Some of the release's tests wait most of their time, for a browser or for processes: one more runs beside them.
WAITING_release := 1
test-release test-sanitize: test-%: build-%
	@RC_PARAMS="$(TEST_RC_PARAMS)" $(TEST_ONE_INPUT) ctest --preset $* -j $$(( $(JOBS) + $(or $(WAITING_$*),0) )) | tee build/$*/ctest.log

# Everything under the sanitizers, not only what handles bytes, arrays and processes.
soak-sanitize: deps-test
	@$(CONFIGURE) --preset sanitize -DCIRCUMSPECT_BUILD_TESTS=ON -DCIRCUMSPECT_SANITIZE_ALL=ON -DCIRCUMSPECT_VALUES_FROM=
	@cmake --build --preset sanitize -j $(JOBS)
	@RC_PARAMS="$(TEST_RC_PARAMS)" ctest --preset sanitize -j $(JOBS)

# Every property and soak test on new random inputs, each for its share of MINUTES, and what cannot be
# cut short if there is room for it; a failure is printed with the command that repeats it. `ctest --preset soak` runs each soak test once instead.
# What ships is optimized more than what `make test` tries: golden rows, certificates and forgeries are tried with it.
soak: deps-test
	@$(MAKE) --no-print-directory -C proofs -j $(JOBS) $(VERIFIED) $(dir $(VERIFIED))answers
	@$(CONFIGURE) --preset release -B build/shipped -DCIRCUMSPECT_BUILD_TESTS=OFF
	@cmake --build build/shipped --target circumspect_cli -j $(JOBS)
	@$(CONFIGURE) --preset release $(ALL_TESTS) $(BROWSER_AND_RANKS) -DCIRCUMSPECT_VERIFIED=$(VERIFIED) \
	  -DCIRCUMSPECT_SHIPPED=$(CURDIR)/build/shipped/bin/circumspect
	@cmake --build --preset release -j $(JOBS)
	@properties/soak.py build/release $(MINUTES)

# Does a test notice each mutant of predicates, checkers, readers and the fast judge (properties/mutants.tsv)?
# Of which places nobody chose, and which tests notice them, says `mutants-generated` (docs/mutants.md), in Python and OCaml too: with CHANGED=1 of the
# files that have changed since, with FILES=oracle/judge/voronoi of some; COUNT=100 tries so many; REST=1 goes on where it was interrupted.
mutants: deps-test
	@python3 properties/mutants.py build/mutants

mutants-generated: deps-test verified
	@cmake/packages.sh mutants
	@/usr/bin/python3 properties/generated_mutants.py build/mutants-generated $(if $(CHANGED),--changed) $(if $(FILES),--files $(FILES)) \
	  $(if $(COUNT),--count $(COUNT)) $(if $(REST),--rest)

# The fuzz targets on new inputs, in turn, for MINUTES altogether: five sixths of them with libFuzzer alone, where the readers take many
# times as many inputs a second; then what was kept, and some more, under the sanitizers.
SETTINGS_fuzz_sanitize := -DCIRCUMSPECT_BUILD_TESTS=ON -DCIRCUMSPECT_SANITIZE_ALL=ON -DCIRCUMSPECT_VALUES_FROM=
SETTINGS_fuzz_fuzz     := -DCIRCUMSPECT_BUILD_TESTS=OFF
SOAK_FUZZ := SEED=$$RANDOM TOTALS=fuzz/targets/totals.tsv CORPUS=build/fuzz-corpus fuzz/targets/run.sh
build-fuzz-fuzz build-fuzz-sanitize: build-fuzz-%: deps-test
	@$(CONFIGURE) --preset $* $(SETTINGS_fuzz_$*)
	@cmake --build --preset $* -j $(JOBS) --target $(patsubst fuzz/targets/%.cpp,%,$(FUZZ_TARGETS))
soak-fuzz: build-fuzz-fuzz build-fuzz-sanitize
	@$(SOAK_FUZZ) build/fuzz/fuzz 0 $$(( $(MINUTES) * 50 / $(words $(FUZZ_TARGETS)) ))
	@$(SOAK_FUZZ) build/sanitize/fuzz 0 $$(( $(MINUTES) * 10 / $(words $(FUZZ_TARGETS)) ))

# Hunts every library of hunt/targets.tsv that Debian and npm have, and those that were built in BUILDS, for TIME each
# (5m). A signature that hunt/runs.tsv does not have of a library is a failure.
soak-hunt: build
	@cmake/packages.sh hunt
	@hunt/hunt.py --install --builds $(or $(BUILDS),build/hunt) --output build/hunts --time $(or $(TIME),5m) --seed $$RANDOM

# What runs on several threads, under ThreadSanitizer.
tsan: deps-test
	@$(CONFIGURE) --preset tsan -DCIRCUMSPECT_BUILD_TESTS=ON
	@cmake --build --preset tsan -j $(JOBS)
	@ctest --preset tsan

# Which lines and arms of conditions of the kernel and the judges the tests run, folder by folder (properties/coverage.py). What limits
# the size of files limits what is counted, too.
coverage: deps-test
	@cmake/packages.sh coverage
	@$(MAKE) --no-print-directory -C proofs -j $(JOBS) $(VERIFIED) $(dir $(VERIFIED))answers
	@$(CONFIGURE) --preset coverage -DCIRCUMSPECT_BUILD_TESTS=ON -DCIRCUMSPECT_VERIFIED=$(VERIFIED)
	@cmake --build --preset coverage -j $(JOBS)
	@rm -rf build/coverage/profiles
	@RC_PARAMS="$(TEST_RC_PARAMS)" $(TEST_ONE_INPUT) LLVM_PROFILE_FILE="$(CURDIR)/build/coverage/profiles/%m.profraw" \
	  ctest --preset coverage -j $(JOBS) -R '^(kernel|oracle|corpus|command|properties|proofs)/|^verified_' -E unfinished_file_command_test \
	  || echo "Tests failed or took too long: what they alone run is missing below." >&2
	@properties/coverage.py build/coverage

BENCH := $(CONFIGURE) --preset release -B build/bench -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_BUILD_BENCHMARKS=ON
bench: deps-bench
	@test -f bench/CMakeLists.txt || { echo "there are no benchmarks yet" >&2; exit 1; }
	@$(BENCH)
	@cmake --build build/bench --target bench -j $(JOBS)

# One table of goals, beside TetGen and the readers of others (bench/goals.py), which GOALS="--divide 30 --rounds 1" tries. The row of
# WebAssembly is there once `make npm` has built the package.
bench-goals: deps-bench
	@$(BENCH) -DCIRCUMSPECT_BUILD_MPI=ON -DCIRCUMSPECT_BUILD_PYTHON=ON
	@cmake --build build/bench --target circumspect_cli circumspect-mpi circumspect_python circumspect_bench -j $(JOBS)
	@/usr/bin/python3 bench/goals.py build/bench $(GOALS)

format: deps-test
	@$(SOURCES) | xargs -r -d '\n' $(CLANG_FORMAT) -i

clean:
	@rm -rf build
