"""Pictures of a heap's fields in the layout of figures 12 to 14: growth on the left, drain on the right, time running down; where two models
computed the heap, side by side."""

import numpy as np

import reproduction  # noqa: F401, finds src/plot
import field_maps
from field_maps import ROMAN
from reproduction import look, plt

# Of the layout [inch].
WIDTH, GAP, BETWEEN, TITLE, LEFT, RIGHT, TOP, BOTTOM = 3.3, 0.08, 0.35, 0.3, 0.75, 1.1, 0.95, 0.6


def draw(heaps, folder, names):
    """One picture a field of field_maps.quantities, under the names given for each."""
    return [draw_one(heaps, folder / f"{names[what[0]]}.png", *what) for what in field_maps.quantities()]


def draw_one(heaps, path, name, symbol, words, colours, read):
    phases = [heap.run.still_outputs() for heap in heaps]   # (growth, drain) of each
    outputs = [(heap, k) for heap, both in zip(heaps, phases) for part in both for k in part]
    low, high = field_maps.limits(name, [field_maps.of_grains(heap.run, k, read) for heap, k in outputs])
    extents = np.array([heap.run.extent([*growth, *drain]) for heap, (growth, drain) in zip(heaps, phases)])
    X0, X1, Z0, Z1 = extents[:, 0].min(), extents[:, 1].max(), extents[:, 2].min(), extents[:, 3].max()
    n_rows = max(len(part) for both in phases for part in both)
    figure, place, colour_axes = make_figure(n_rows, 2 * len(heaps), (Z1 - Z0) / (X1 - X0))
    for phase in (0, 1):
        for number, (heap, both) in enumerate(zip(heaps, phases)):
            column = phase * len(heaps) + number
            for row, k in enumerate(both[phase]):
                axes = place(row, column, last=row == len(both[phase]) - 1)
                mesh = field_maps.paint(axes, heap.run, k, name, field_maps.of_grains(heap.run, k, read), cmap=colours, vmin=low, vmax=high)
                axes.set(aspect="equal", xlim=(X0, X1), ylim=(Z0, Z1))
                of = f"{heap.label}\n" if row == 0 else ""
                axes.set_title(f"{of}({'ab'[phase]} {ROMAN[row]})  t = {look.seconds(heap.run.times[k])}", loc="left", fontsize=10)
    figure.colorbar(mesh, cax=colour_axes, label=symbol, extend="both" if name == "inertial_number" else "max")
    figure.suptitle(f"Heap of 4.6 g/s: {words} (a: growth, b: drain)", y=1.0 - 0.1 / figure.get_figheight(), va="top")
    figure.savefig(path)
    plt.close(figure)
    return path


def make_figure(n_rows, n_columns, aspect):
    """A figure, a function that makes the axes at (row, column), and axes for a colour bar. By hand, in inches, as in field_maps."""
    height = WIDTH * aspect
    W = LEFT + n_columns * WIDTH + (n_columns - 2) * GAP + BETWEEN + RIGHT
    H = TOP + n_rows * height + (n_rows - 1) * TITLE + BOTTOM
    figure = plt.figure(figsize=(W, H), layout="none")

    def place(row, column, last):
        second = column >= n_columns // 2
        x = LEFT + column * WIDTH + (column - second) * GAP + second * BETWEEN
        y = H - TOP - (row + 1) * height - row * TITLE
        axes = figure.add_axes([x / W, y / H, WIDTH / W, height / H])
        axes.tick_params(labelleft=column == 0, labelbottom=last)
        axes.set_ylabel("Z [m]" if column == 0 else "")
        axes.set_xlabel("X [m]" if last else "")
        return axes
    return figure, place, figure.add_axes([1.0 - (RIGHT - 0.25) / W, 0.5 - 2.5 / H, 0.2 / W, 5.0 / H])
