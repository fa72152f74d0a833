"""The whole event as a movie: speed in the heap above, mass flow below, one frame a simulated second."""

import shutil
import subprocess

import numpy as np
from matplotlib.collections import LineCollection

import look
from look import plt
from run_data import Missing

WIDTH, HEIGHT, DPI = 1280, 960, 120  # pixels, even as yuv420p demands
FRAMES_A_SECOND = 25


def draw(run, folder, progress):
    if shutil.which("ffmpeg") is None:
        raise Missing("ffmpeg is not installed: no movie")
    path = folder / "movie.mp4"
    times = frame_times(run)
    scene = (FieldScene if FieldScene.fits(run, times) else SurfaceScene)(run)
    frames = Frames(run, scene)
    # Raw frames through a pipe: matplotlib's own writers would save or encode each figure anew.
    encoder = subprocess.Popen(
        ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgba", "-s", f"{WIDTH}x{HEIGHT}",
         "-r", str(FRAMES_A_SECOND), "-i", "-", "-c:v", "libx264", "-preset", "veryfast", "-crf", "20",
         "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path)], stdin=subprocess.PIPE)
    try:
        for number, t in enumerate(times):
            encoder.stdin.write(frames.draw(t))
            progress((number + 1) / len(times))
        encoder.stdin.close()
    except BrokenPipeError:
        pass  # ffmpeg has said why
    finally:
        plt.close(frames.figure)
    if encoder.wait() != 0:
        raise Missing("ffmpeg failed: no movie")
    return [path]


def frame_times(run):
    """One a second, or 120 of a run shorter than 20 s."""
    interval = 1.0 if run.duration >= 20.0 else max(run.duration / 120.0, 1e-9)
    return run.times[0] + interval * np.arange(int(run.duration / interval + 1e-6) + 1)


class FieldScene:
    """The field of speed on its moving mesh. Between two outputs mesh and values are interpolated in time."""

    @staticmethod
    def fits(run, times):
        if run.times.size < 2 or times.size < 2 or not run.has("speed", "z_node"):
            return False
        return np.median(np.diff(run.times)) <= 2.5 * (times[1] - times[0])

    def __init__(self, run):
        self.run = run
        self.kept = {}
        sample = np.unique(np.linspace(0, run.times.size - 1, 24).round().astype(int))
        self.top_speed = max(1e-12, *(top_speed(run.grains_only(run.field("speed", k), k), run.is_film(run.field("height", k)))
                                      for k in sample))
        self.outputs = sample
        self.coloured = True

    def record(self, k):
        if k not in self.kept:
            self.kept = {i: v for i, v in self.kept.items() if i >= k - 1}
            self.kept[k] = (self.run.field("z_node", k), self.run.grains_only(self.run.field("speed", k), k), self.run.field("height", k))
        return self.kept[k]

    def artists(self, axes, t):
        run = self.run
        k = int(np.clip(np.searchsorted(run.times, t) - 1, 0, max(run.times.size - 2, 0)))
        after = min(k + 1, run.times.size - 1)
        weight = np.clip((t - run.times[k]) / max(run.times[after] - run.times[k], 1e-12), 0.0, 1.0)
        z, speed, height = ((1.0 - weight) * a + weight * b for a, b in zip(self.record(k), self.record(after)))
        speed[:, run.is_film(height)] = np.ma.masked
        X, Z = run.to_gravity(np.broadcast_to(run.x_face, z.shape), z)
        mesh = axes.pcolormesh(X, Z, speed, vmin=0.0, vmax=self.top_speed, antialiased=False)
        line, = axes.plot(*run.surface(height), color=look.INK, linewidth=0.8)
        return [mesh, line]


class SurfaceScene:
    """The surface from the dense series, where fields are too far apart, or from the outputs; coloured by its speed if that is known."""

    def __init__(self, run):
        self.run = run
        dense = run.has("height_series")
        self.times = run.series_times if dense else run.times
        self.height = run.series("height_series") if dense else run.values("height")
        self.speed = run.series("surface_speed_series") if run.has("surface_speed_series") else None
        self.coloured = self.speed is not None
        if self.coloured:
            self.top_speed = max(1e-12, *(top_speed(u, run.is_film(h)) for u, h in zip(self.speed, self.height)))
        self.outputs = np.arange(run.times.size)

    def artists(self, axes, t):
        run = self.run
        i = int(np.argmin(np.abs(self.times - t)))
        grains, = axes.fill(*run.outline(self.height[i]), color=look.GRAINS, linewidth=0)
        if not self.coloured:
            return [grains, *axes.plot(*run.surface(self.height[i]), color=look.INK, linewidth=1.2)]
        points = np.stack(run.to_gravity(run.x, self.height[i]), axis=-1)
        line = LineCollection(np.stack([points[:-1], points[1:]], axis=1), array=self.speed[i][:-1], linewidths=3.0)
        line.set_clim(0.0, self.top_speed)
        axes.add_collection(line, autolim=False)
        return [grains, line]


def top_speed(speed, film):
    values = speed[..., ~film]
    values = np.ma.masked_invalid(values).compressed()
    return float(np.percentile(values, 99.8)) if values.size else 0.0


class Frames:
    """Draws what stays once, then only what moves on a copy of it."""

    def __init__(self, run, scene):
        self.run, self.scene = run, scene
        self.figure = plt.figure(figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI)
        self.heap, self.rate = self.figure.subplots(2, 1, gridspec_kw={"height_ratios": [4.2, 1.0]})
        X0, X1, Z0, Z1 = run.extent(scene.outputs)
        look.grid(self.heap)
        self.heap.plot(*run.base(), color=look.INK, linewidth=2.0)
        self.heap.set(aspect="equal", xlim=(X0, X1), ylim=(Z0, Z1), xlabel="X, horizontal [m]", ylabel="Z, up [m]")
        if scene.coloured:
            colours = plt.cm.ScalarMappable(plt.Normalize(0.0, scene.top_speed))
            self.figure.colorbar(colours, ax=self.heap, label="speed [m s$^{-1}$]", extend="max", shrink=0.9)
        self.figure.suptitle(run.name)
        self.draw_rates()
        self.figure.canvas.draw()
        self.figure.set_layout_engine("none")
        self.background = self.figure.canvas.copy_from_bbox(self.figure.bbox)

    def draw_rates(self):
        run, axes = self.run, self.rate
        look.grid(axes)
        if run.has("inflow_rate", "outflow_rate_right"):
            axes.plot(run.series_times, 1e3 * run.series("inflow_rate"), color=look.FAINT, label="in")
            axes.plot(run.series_times, 1e3 * run.series("outflow_rate_right"), color=look.BLUE, label="out")
            axes.legend(loc="upper right", ncol=2)
        axes.set(xlabel="time [s]", ylabel="flow [g s$^{-1}$]",
                 xlim=(run.times[0], run.times[0] + max(run.duration, 1e-9)))

    def draw(self, t):
        """The frame at time t as RGBA bytes."""
        canvas = self.figure.canvas
        canvas.restore_region(self.background)
        moving = [(self.heap, artist) for artist in self.scene.artists(self.heap, t)]
        clock = f"t = {t:.0f} s" if self.run.duration >= 20.0 else f"t = {t:.2f} s"
        moving.append((self.heap, self.heap.text(0.97, 0.95, clock, transform=self.heap.transAxes, ha="right", va="top",
                                                 fontsize=16)))
        moving.append((self.rate, self.rate.axvline(t, color=look.ACCENT, linewidth=1.5)))
        for axes, artist in moving:
            axes.draw_artist(artist)
        frame = bytes(canvas.buffer_rgba())
        for _, artist in moving:
            artist.remove()
        return frame
