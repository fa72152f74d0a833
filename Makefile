# A signpost over CMake: `make help` lists the ways. All building is in CMakeLists.txt.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory

JOBS    ?= $(shell nproc)
RELEASE := build/release
FUZZ_SECONDS ?= 600
SCENE   ?= runs/examples/heap_q46.toml
OUT     ?= out/$(basename $(notdir $(SCENE)))
# Debian's own Python first: it has the packages, another one on the PATH may not.
PYTHON  := $(firstword $(wildcard /usr/bin/python3) python3)

# UMFPACK calls a BLAS from one thread: threads of OpenBLAS would fight over the cores (ten times slower on two busy ones).
export OPENBLAS_NUM_THREADS := 1

BUILD_PACKAGES := g++ cmake make pkg-config libsundials-dev libsuitesparse-dev libmumps-seq-dev libopenblas-serial-dev libeigen3-dev libspectra-dev libnetcdf-dev nettle-dev \
  libtomlplusplus-dev libcli11-dev libspdlog-dev nlohmann-json3-dev libceres-dev libgtest-dev libbenchmark-dev
PICTURE_PACKAGES := python3 python3-numpy python3-xarray python3-netcdf4 python3-matplotlib python3-pil ffmpeg
TEST_PACKAGES := parallel shellcheck chromium chromium-driver python3-selenium
SLOW_PACKAGES := snakemake
CHECK_PACKAGES := git clang-format clang-tidy-16
# Not Debian's default clang 14, which cannot read the ranges of g++ 12's library.
FUZZ_PACKAGES := clang-16 libclang-rt-16-dev libomp-16-dev

.PHONY: help deps configure run paper test test-slow test-all planted fuzz bench format check check-all clean

help: ## this list
	@echo "make WAY, where WAY is one of"
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  \1\t\2/p' Makefile | expand -t 14

deps: ## install missing Debian packages (run and test call it by themselves)
	@.ci/deps $(BUILD_PACKAGES) $(PICTURE_PACKAGES)

configure: deps
	@cmake -S . -B $(RELEASE) -DCMAKE_BUILD_TYPE=Release --log-level=WARNING

run: configure ## grow the heap and let it drain; SCENE=file.toml OUT=folder for another scene
	@cmake --build $(RELEASE) -j $(JOBS) --target talus
	@$(RELEASE)/talus run $(SCENE) --out $(OUT) --force
	@$(RELEASE)/talus plot $(OUT) --movie
	@echo "Results: $(OUT)/run.nc, summary in $(OUT)/summary.json. Pictures and movie:"
	@find $(OUT) -name '*.png' -o -name '*.mp4' | sort | sed 's/^/  /'

paper: configure ## every computed figure and printed number of the paper beside ours, as one page: out/paper/index.html; goes on where it was stopped
	@cmake --build $(RELEASE) -j $(JOBS) --target talus
	@$(PYTHON) runs/paper/reproduce.py --talus $(RELEASE)/talus --out out/paper

test: configure ## build and run all tests but the slow ones
	@.ci/deps $(TEST_PACKAGES)
	@cmake --build $(RELEASE) -j $(JOBS)
	@ctest --test-dir $(RELEASE) --output-on-failure -j $(JOBS) --timeout 600 --label-exclude slow --no-tests=error

test-slow: configure ## the tests that need minutes: refinement studies of whole scenes
	@.ci/deps $(SLOW_PACKAGES)
	@cmake --build $(RELEASE) -j $(JOBS)
	@ctest --test-dir $(RELEASE) --output-on-failure -j $(JOBS) --timeout 7200 --label-regex slow --no-tests=error

test-all: test test-slow ## all tests; what the slow ones gave last stands in tests/README.md

planted: deps ## plant each known fault in a copy of the tree and see its test fail (an hour); FAULTS=regular-expression for some
	@.ci/deps $(TEST_PACKAGES)
	@$(PYTHON) tests/planted/run.py $(if $(FAULTS),'$(FAULTS)')

fuzz: ## feed the reader of scenes with what libFuzzer thinks up; FUZZ_SECONDS=600
	@.ci/deps $(BUILD_PACKAGES) $(FUZZ_PACKAGES)
	@cmake -S . -B build/fuzz -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG='-O1 -g1' -DCMAKE_C_COMPILER=clang-16 -DCMAKE_CXX_COMPILER=clang++-16 \
	  -DTALUS_FUZZ=ON -DTALUS_SANITIZE=address,undefined -DTALUS_WERROR=OFF --log-level=WARNING
	@cmake --build build/fuzz -j $(JOBS) --target test_fuzz_scene
	@mkdir -p build/fuzz/corpus
	@build/fuzz/tests/test_fuzz_scene -max_total_time=$(FUZZ_SECONDS) -max_len=8192 -timeout=20 -artifact_prefix=build/fuzz/ \
	  -seed_inputs=$$(echo runs/examples/*.toml | tr ' ' ,) build/fuzz/corpus

bench: configure ## time kernels and small scenes, beside the last result of this machine; never asserted
	@cmake --build $(RELEASE) -j $(JOBS) --target talus bench
	@$(PYTHON) runs/benchmarks/bench.py --build $(RELEASE)

format: ## rewrite all C++ files to .clang-format
	@.ci/deps $(CHECK_PACKAGES)
	@git ls-files --cached --others --exclude-standard '*.hpp' '*.cpp' | xargs -r clang-format -i

check: configure ## formatting, clang-tidy on what changed, architecture, sanitizers on unit and conformance tests
	@.ci/deps $(CHECK_PACKAGES)
	@.ci/check $(RELEASE) $(TIDY)
	@cmake --build $(RELEASE) -j $(JOBS) --target tests_architecture
	@ctest --test-dir $(RELEASE) --output-on-failure --label-regex architecture --no-tests=error
	@cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG='-O1 -g1' -DTALUS_SANITIZE=address,undefined \
	  --log-level=WARNING
	@cmake --build build/sanitize -j $(JOBS) --target tests_unit tests_conformance
	@ctest --test-dir build/sanitize --output-on-failure -j $(JOBS) --timeout 1200 --label-regex 'unit|conformance' --label-exclude slow --no-tests=error

check-all: ## check, with clang-tidy on every file
	@$(MAKE) check TIDY=all

clean: ## remove what was built; results in out/ stay
	@cmake -E rm -rf build
