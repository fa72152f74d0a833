# The faults themselves are planted by `make planted`; here, quickly, that each still has its place in the tree.
add_test(NAME planted_faults_have_their_places COMMAND ${TALUS_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/planted/run.py --check)
set_tests_properties(planted_faults_have_their_places PROPERTIES LABELS architecture)
