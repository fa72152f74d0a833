talus_test(verification steady_uniform_flow ROOMS steady LIBRARIES nlohmann_json::nlohmann_json)
