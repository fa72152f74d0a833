# talus_benchmark(<file without .cpp> ROOMS <rooms>...): built by the target `bench` alone; runs/benchmarks/bench.py runs them.
find_package(benchmark REQUIRED)
add_custom_target(bench)

function(talus_benchmark name)
  cmake_parse_arguments(ARG "" "" "ROOMS" ${ARGN})
  list(TRANSFORM ARG_ROOMS PREPEND talus_)
  add_executable(bench_${name} EXCLUDE_FROM_ALL ${CMAKE_CURRENT_SOURCE_DIR}/benchmark/${name}.cpp)
  target_include_directories(bench_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(bench_${name} PRIVATE ${ARG_ROOMS} benchmark::benchmark_main)
  add_dependencies(bench bench_${name})
endfunction()

talus_benchmark(dual ROOMS core rheology)
talus_benchmark(layer ROOMS core linear layer)
talus_benchmark(sparse_pattern ROOMS core)
talus_benchmark(stiffness ROOMS core linear bridge ida arkode column steady)
