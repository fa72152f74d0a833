"""Profiles through the flowing layer, along normals of the surface, beside the exact steady ones (figures 17, 18)."""

import numpy as np

import look
from look import plt
from run_data import Missing

N_POSITIONS = 6
N_POINTS = 240


def draw(run, folder):
    if run.x.size < 2:
        raise Missing("profiles along normals need two columns")
    k = run.steady_output
    height = run.field("height", k)
    positions = slice_positions(run, k, height)
    if len(positions) == 0:
        raise Missing("no column is deeper than the film: no profiles")
    speed, inertia = run.field("speed", k), run.field("inertial_number", k)
    depth_max = flowing_depth(run, k, height, speed, positions)
    s = np.linspace(0.0, depth_max, N_POINTS)
    slices = [Slice(run, k, height, x, s) for x in positions]
    colours = look.sequence_colours(len(slices), "plasma")
    exact = Exact(run)

    figure, panels = plt.subplots(2, 2, figsize=(12.0, 9.0))
    draw_map(panels[0, 0], run, k, slices, colours)
    draw_speed(panels[0, 1], slices, speed, colours, exact)
    draw_log_speed(panels[1, 0], slices, speed, colours, exact)
    draw_inertia(panels[1, 1], slices, inertia, colours, exact)
    for number, words in enumerate(("where", "speed", "speed, creep included", "inertial number")):
        axes = panels.flat[number]
        look.label(axes, number, words)
        look.grid(axes)
    figure.suptitle(f"{run.name}: profiles normal to the surface at t = {look.seconds(run.times[k])}")
    return [look.save(figure, folder, "profiles.png")]


class Exact:
    """The exact steady layer for the scene's inflow; empty where the run has none."""

    def __init__(self, run):
        self.known = run.has("exact_depth", "exact_speed", "exact_inertial_number")
        if self.known:
            self.depth = np.abs(run.values("exact_depth"))
            order = np.argsort(self.depth)
            self.depth = self.depth[order]
            self.speed = run.values("exact_speed")[order]
            self.inertial_number = run.values("exact_inertial_number")[order]
            self.known = bool(np.isfinite(self.speed).any())


class Slice:
    """Points at depths s [m] along the inward normal of the surface at x, and a field's values there."""

    def __init__(self, run, k, height, x, s):
        self.run, self.x, self.s = run, x, s
        self.z_centre = run.field("z", k)
        self.height = height
        self.slope = local_slope(run.x, height, x)
        n = np.array([-self.slope, 1.0]) / np.hypot(self.slope, 1.0)
        self.x_points = x - s * n[0]
        self.z_points = np.interp(x, run.x, height) - s * n[1]

    def values(self, field, to_surface=False):
        """Interpolated along x at equal depth below the surface, where it changes least; NaN outside the grains, and
        above the middle of the top cell unless it is to be extended `to_surface`."""
        x = self.run.x
        depth = np.interp(self.x_points, x, self.height) - self.z_points
        i = np.clip(np.searchsorted(x, self.x_points) - 1, 0, x.size - 2)
        weight = (self.x_points - x[i]) / (x[i + 1] - x[i])
        low = np.array([self.column(field, j, d, to_surface) for j, d in zip(i, depth)])
        high = np.array([self.column(field, j + 1, d, to_surface) for j, d in zip(i, depth)])
        result = (1.0 - weight) * low + weight * high
        result[(self.z_points < 0.0) | (weight < -0.5) | (weight > 1.5)] = np.nan
        return result

    def column(self, field, j, depth, to_surface):
        below = self.height[j] - self.z_centre[::-1, j]
        column = field[::-1, j]
        if to_surface and depth < below[0]:
            return column[0] + (column[1] - column[0]) * (depth - below[0]) / (below[1] - below[0])
        return np.interp(depth, below, column, left=np.nan, right=np.nan)


def local_slope(x, height, at):
    """dH/dx from a straight line through the columns within 3 % of the box."""
    near = np.abs(x - at) <= max(0.03 * (x[-1] - x[0]), 1.5 * (x[1] - x[0]))
    return float(np.polyfit(x[near], height[near], 1)[0])


def slice_positions(run, k, height):
    """Places between the apex and the outlet, well away from both; along the whole layer where there is no inflow."""
    x0, x1 = run.x[0], run.x[-1]
    if float(run.attribute("inflow_rate_kg_s", 0.0)) > 0.0:
        apex = run.x[int(np.argmax(height))]
        x0 = apex if apex < x0 + 0.8 * (x1 - x0) else x0
    wanted = x0 + np.linspace(0.2, 0.85, N_POSITIONS) * (x1 - x0)
    columns = sorted({int(np.argmin(np.abs(run.x - x))) for x in wanted})
    return [run.x[j] for j in columns if not run.is_film(height[j])]


def flowing_depth(run, k, height, speed, positions):
    """Depth to show [m]: 2.5 times that at which the speed has fallen to a fiftieth, at the slowest of the places."""
    z = run.field("z", k)
    depths = []
    for x in positions:
        j = int(np.argmin(np.abs(run.x - x)))
        moving = speed[:, j] > 0.02 * speed[-1, j]
        depths.append(height[j] - z[np.argmax(moving), j])
    return float(2.5 * max(depths)) if max(depths) > 0.0 else float(max(height))


def draw_map(axes, run, k, slices, colours):
    axes.fill(*run.outline(run.field("height", k)), color=look.GRAINS, linewidth=0)
    axes.plot(*run.surface(run.field("height", k)), color=look.INK, linewidth=1.0)
    axes.plot(*run.base(), color=look.INK, linewidth=2.0)
    for cut, colour in zip(slices, colours):
        inside = cut.z_points >= 0.0
        axes.plot(*run.to_gravity(cut.x_points[inside], cut.z_points[inside]), color=colour, linewidth=2.5)
        axes.plot(*run.to_gravity(cut.x_points[:1], cut.z_points[:1]), "o", color=colour, markersize=4)
    X0, X1, Z0, Z1 = run.extent([k])
    axes.set(aspect="equal", xlim=(X0, X1), ylim=(Z0, Z1))
    axes.set(xlabel="X, horizontal [m]", ylabel="Z, up [m]")


def face_angle(cut):
    return cut.run.tilt - np.degrees(np.arctan(cut.slope))


def draw_speed(axes, slices, field, colours, exact):
    for cut, colour in zip(slices, colours):
        u = cut.values(field, to_surface=True)
        error = error_words(cut.s, u, exact.depth, exact.speed) if exact.known else ""
        axes.plot(u, 1e3 * cut.s, color=colour, label=f"x = {cut.x:.3f} m, {face_angle(cut):.2f}°{error}")
    if exact.known:
        axes.plot(exact.speed, 1e3 * exact.depth, color=look.INK, linestyle="-.", label="exact, steady")
    axes.set(xlabel="speed [m s$^{-1}$]", ylabel="depth normal to the surface [mm]", ylim=(1e3 * slices[0].s[-1], 0.0))
    axes.set_xlim(left=0.0)
    axes.legend(loc="lower right", title="place, slope of the surface" + (", L2 error" if exact.known else ""))


def error_words(s, u, depth, reference):
    """Relative L2 difference over the exact layer's depth, in words."""
    inside = (s <= depth[-1]) & np.isfinite(u)
    wanted = np.interp(s[inside], depth, reference)
    norm = np.sqrt(np.sum(wanted ** 2))
    return f", {100.0 * np.sqrt(np.sum((u[inside] - wanted) ** 2)) / norm:.1f} %" if norm > 0.0 else ""


def draw_log_speed(axes, slices, field, colours, exact):
    top = 0.0
    for cut, colour in zip(slices, colours):
        u = cut.values(field, to_surface=True)
        top = max(top, np.nanmax(u))
        axes.semilogx(np.where(u > 0.0, u, np.nan), 1e3 * cut.s, color=colour)
    if exact.known:
        moving = exact.speed > 0.0
        axes.semilogx(exact.speed[moving], 1e3 * exact.depth[moving], color=look.INK, linestyle="-.")
    axes.set(xlabel="speed [m s$^{-1}$]", ylabel="depth normal to the surface [mm]", ylim=(1e3 * slices[0].s[-1], 0.0))
    if top > 0.0:
        axes.set_xlim(1e-6 * top, 2.0 * top)


def draw_inertia(axes, slices, field, colours, exact):
    for cut, colour in zip(slices, colours):
        axes.plot(cut.values(field), 1e3 * cut.s, color=colour)
    if exact.known:
        axes.plot(exact.inertial_number, 1e3 * exact.depth, color=look.INK, linestyle="-.")
    axes.set(xlabel="I [1]", ylabel="depth normal to the surface [mm]", ylim=(1e3 * slices[0].s[-1], 0.0))
    axes.set_xlim(left=0.0)
