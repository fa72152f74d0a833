"""Which pictures belong to a run: (words, draw, caption) each, in the order in which a reader wants them."""

import class_shares
import column_history
import column_profiles
import column_regularisations
import field_maps
import heap_shapes
import layer_profiles
import mass_curves
import solver_history

OF_COLUMN = (
    ("profiles", column_profiles.draw, "Velocity, inertial number and viscosity through the layer at several times; dash-dotted: the exact steady flow."),
    ("history", column_history.draw, "Speed, mass flow, the box, and what acts on the layer."),
    ("regularisations", column_regularisations.draw, "Where and when each named regularisation acts."),
    ("well-posedness", class_shares.draw, "Shares of the flowing layer by class. Where short waves grow, finer grids need not agree."),
    ("integrator", solver_history.draw, "Steps, order, failures, CPU time and the error of the balance."))
OF_TWO_DIMENSIONS = (
    ("heap shapes", heap_shapes.draw, "The free surface in gravity's coordinates, as it grows and as it drains."),
    ("fields", field_maps.draw, "Fields at the paper's times, or those nearest to them. Columns no deeper than twice the film are blank."),
    ("mass", mass_curves.draw, "Mass in the box, mass that passed its ends, and rates."),
    ("profiles", layer_profiles.draw, "Through the flowing layer along normals of the right face, beside the exact steady flow."),
    ("well-posedness", class_shares.draw, "Shares of the flowing area and of its flux by class. Where short waves grow, finer grids need not agree."),
    ("integrator", solver_history.draw, "Steps, order, failures, CPU time and the error of the balance."))


def of(run):
    return OF_COLUMN if run.is_column else OF_TWO_DIMENSIONS
