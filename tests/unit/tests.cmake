talus_test(unit dual ROOMS core)
talus_test(unit config_read ROOMS config)
talus_test(unit config_spelling ROOMS config)
