talus_test(extremes steady_slopes ROOMS steady LIBRARIES nlohmann_json::nlohmann_json)
talus_test(extremes steady_scales ROOMS steady LIBRARIES nlohmann_json::nlohmann_json)
talus_test(extremes steady_refusals ROOMS steady LIBRARIES nlohmann_json::nlohmann_json)
