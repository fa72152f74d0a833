talus_test(verification steady_uniform_flow ROOMS steady LIBRARIES nlohmann_json::nlohmann_json)
talus_test(verification steady_regularised_profile ROOMS steady)
talus_test(verification layer_uniform ROOMS app)
talus_test(verification heap_steady ROOMS app LABELS slow)
