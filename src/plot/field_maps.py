"""Speed, pressure and inertial number in the heap at the paper's times (figures 12-14)."""

import numpy as np

import look
from look import plt

COLUMNS = 3
CLOSE_UP = 0.036  # width of the close-up of the face [m]
ROMAN = ("i", "ii", "iii", "iv", "v", "vi", "vii", "viii")


def draw(run, folder):
    growth, drain = run.still_outputs()
    phases = [("a", k) for k in growth] + [("b", k) for k in drain]
    return [draw_one(run, folder, phases, *what) for what in quantities()]


def quantities():
    """(name, symbol, words, colours, reader) of each field that is drawn."""
    return (("speed", "|u| [m s$^{-1}$]", "speed", "viridis", speed), ("pressure", "p [Pa]", "pressure", "cividis", pressure),
            ("inertial_number", "log$_{10}$ I", "inertial number", "magma", log_inertial_number))


def speed(run, k):
    return run.field("speed", k)


def pressure(run, k):
    return run.field("pressure", k)


def log_inertial_number(run, k):
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.log10(run.field("inertial_number", k))


def of_grains(run, k, read):
    """A field without air and without columns that hold no more than the film."""
    masked = run.grains_only(read(run, k), k)
    masked[:, run.is_film(run.field("height", k))] = np.ma.masked
    return masked


def limits(name, fields):
    """Colour limits that one hot cell does not spoil."""
    values = np.concatenate([f.compressed() for f in fields])
    values = values[np.isfinite(values)]
    if values.size == 0:
        return 0.0, 1.0
    if name == "inertial_number":
        high = np.ceil(2.0 * np.percentile(values, 99.9)) / 2.0
        return max(high - 6.0, np.floor(values.min())), high
    return 0.0, max(float(np.percentile(values, 99.9)), 1e-12)


def make_panels(n, aspect):
    """A figure with n panels of height/width `aspect` in rows, and axes for a colour bar. Laid out by hand, in inches:
    matplotlib's layout engine would take most of the time."""
    width, left, right, top, bottom, gap, title = 3.9, 0.8, 1.3, 0.85, 0.65, 0.2, 0.45
    height = width * max(aspect, 0.3)
    rows = -(-n // COLUMNS)
    W = left + COLUMNS * width + (COLUMNS - 1) * gap + right
    H = top + rows * height + (rows - 1) * title + bottom
    figure = plt.figure(figsize=(W, H), layout="none")
    panels = []
    for i in range(n):
        row, column = divmod(i, COLUMNS)
        x, y = left + column * (width + gap), bottom + (rows - 1 - row) * (height + title)
        axes = figure.add_axes([x / W, y / H, width / W, height / H])
        axes.tick_params(labelleft=column == 0, labelbottom=i + COLUMNS >= n)
        axes.set_ylabel("Z [m]" if column == 0 else "")
        axes.set_xlabel("X [m]" if i + COLUMNS >= n else "")
        panels.append(axes)
    tall = min(H - top - bottom, 5.5)
    return figure, panels, figure.add_axes([1.0 - (right - 0.25) / W, 0.5 - 0.5 * tall / H, 0.2 / W, tall / H])


def draw_one(run, folder, phases, name, symbol, words, colours, read):
    outputs = [k for _, k in phases]
    fields = [of_grains(run, k, read) for k in outputs]
    low, high = limits(name, fields)

    X0, X1, Z0, Z1 = run.extent(outputs)
    close_up = X1 - X0 > 8.0 * CLOSE_UP
    if close_up:
        X1 += 0.18 * (X1 - X0)  # room for it
    figure, panels, colour_axes = make_panels(len(phases), (Z1 - Z0) / (X1 - X0))
    count = {"a": 0, "b": 0}
    for axes, (phase, k), field in zip(panels, phases, fields):
        mesh = paint(axes, run, k, name, field, cmap=colours, vmin=low, vmax=high)
        axes.set(aspect="equal", xlim=(X0, X1), ylim=(Z0, Z1))
        if close_up:
            draw_close_up(axes, run, k, lambda on: paint(on, run, k, name, field, cmap=colours, vmin=low, vmax=high))
        axes.set_title(f"({phase} {ROMAN[count[phase] % len(ROMAN)]})  t = {look.seconds(run.times[k])}", loc="left")
        count[phase] += 1
    figure.colorbar(mesh, cax=colour_axes, label=symbol, extend="both" if name == "inertial_number" else "max")
    title = f"{run.name}: {words}" + (" (a: growth, b: drain)" if count["b"] else "")
    if name == "inertial_number" and any(cap_has_outline(run, k) for k in outputs):
        title += "; the viscosity is capped inside the dashed line"
    figure.suptitle(title, y=1.0 - 0.15 / figure.get_figheight(), va="top")
    return look.save(figure, folder, f"field_{name}.png")


def paint(axes, run, k, name, field, **colours):
    """The field with the surface and the base, as mesh."""
    mesh = axes.pcolormesh(*run.nodes(k), field, **colours)
    axes.plot(*run.surface(run.field("height", k)), color=look.INK, linewidth=0.6)
    axes.plot(*run.base(), color=look.INK, linewidth=1.4)
    if name == "inertial_number":
        draw_cap(axes, run, k)
    return mesh


def draw_close_up(axes, run, k, paint):
    """The middle of the right face again, in the empty corner above it: the layer that flows is millimetres deep."""
    height = run.field("height", k)
    X, Z = run.to_gravity(run.x, height)
    middle = (int(np.argmax(height)) + height.size - 1) // 2
    if run.is_film(height[middle]):
        return
    (X0, X1), (Z0, Z1) = axes.get_xlim(), axes.get_ylim()
    left, bottom, wide, high = 0.69, 0.5, 0.31, 0.48
    if np.any((X > X0 + left * (X1 - X0)) & (Z > Z0 + bottom * (Z1 - Z0))):
        return  # the heap itself is there
    corner = axes.inset_axes([left, bottom, wide, high])
    paint(corner)
    half, tall = 0.5 * CLOSE_UP, 0.5 * CLOSE_UP * (high * (Z1 - Z0)) / (wide * (X1 - X0))
    corner.set(xlim=(X[middle] - half, X[middle] + half), ylim=(Z[middle] - 1.35 * tall, Z[middle] + 0.65 * tall),
               xticks=[], yticks=[], aspect="equal")
    corner.spines[["top", "right"]].set_visible(True)
    axes.indicate_inset_zoom(corner, edgecolor=look.INK, alpha=0.6)
    corner.set_title(f"{1e3 * CLOSE_UP:.0f} mm wide", fontsize=9, pad=2)


def cap_has_outline(run, k):
    """Whether the viscosity is capped somewhere but not everywhere."""
    if not run.has("cap_active"):
        return False
    cap = np.nan_to_num(run.field("cap_active", k))
    return min(cap.shape) > 1 and cap.min() < cap.max()


def draw_cap(axes, run, k):
    """Dashed outline of the region where the viscosity is capped."""
    if not cap_has_outline(run, k):
        return
    cap = np.nan_to_num(run.field("cap_active", k))
    X, Z = run.to_gravity(np.broadcast_to(run.x, cap.shape), run.field("z", k))
    axes.contour(X, Z, cap, levels=[0.5], colors="white", linestyles="dashed", linewidths=1.0)
