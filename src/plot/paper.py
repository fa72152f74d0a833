"""Numbers printed in the paper, and what follows from its printed parameters."""

INFLOW_RATE = 0.0046  # kg/s
INFLOW_STOP = 150.0   # s
TILT = 29.2           # degree

# Figures 12-14: times of the panels in s; figure 12's "areas", which are consistent if read as kg in the box.
GROWTH_TIMES = (7.2, 12.4, 16.8, 30.8, 56.0, 150.0)
DRAIN_TIMES = (151.2, 155.2, 174.4, 202.0, 252.0, 297.6)
MASS_TIMES = (7.2, 12.4, 16.8, 30.8, 56.0, 150.0, 151.2, 155.2, 174.4, 202.0, 252.0, 297.6)
MASSES = (0.02, 0.045, 0.065, 0.11, 0.15, 0.175, 0.175, 0.16, 0.11, 0.08, 0.04, 0.01)

# Steady slope of the right face in degrees: exact for the printed parameters of table 2, and as printed.
SLOPE_EXACT = 48.8126
SLOPE_PRINTED = 47.99
