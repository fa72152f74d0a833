talus_test(conformance every_model ROOMS app)
talus_test(conformance column ROOMS app)
talus_test(conformance layer ROOMS app)
