talus_test(architecture house)
talus_test(architecture deps)
