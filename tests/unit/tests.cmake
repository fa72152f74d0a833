talus_test(unit dual ROOMS core)
