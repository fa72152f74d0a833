talus_test(architecture house)
