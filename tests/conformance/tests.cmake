talus_test(conformance layer ROOMS app)
