"""A uniform layer in motion: the profile of speed above, the surface's speed in time below."""

import numpy as np

import look
from column_profiles import depths, thickness
from look import plt

WIDTH, HEIGHT, DPI = 1280, 960, 120  # pixels


class Frames:
    """Draws what stays once, then only what moves on a copy of it. Between two outputs the profile is interpolated in time."""

    def __init__(self, run):
        self.run, self.depth = run, 1e3 * depths(run)
        self.u = run.values("u")
        self.figure, (self.profile, self.speed) = plt.subplots(2, 1, figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI, height_ratios=[3.4, 1.0])
        pad = 0.04 * max(np.ptp(self.u), 1e-12)
        self.profile.set(xlim=(self.u.min() - pad, self.u.max() + pad), ylim=(1e3 * thickness(run), 0.0),
                         xlabel="velocity down the slope [m s$^{-1}$]", ylabel="depth below the surface [mm]")
        self.speed.plot(run.series_times, run.series("surface_speed"), color=look.BLUE)
        self.speed.set(xlabel="time [s]", ylabel="surface [m s$^{-1}$]", xlim=(run.times[0], run.times[0] + max(run.duration, 1e-9)))
        for axes in (self.profile, self.speed):
            look.grid(axes)
        self.figure.suptitle(run.name)
        self.figure.canvas.draw()
        self.figure.set_layout_engine("none")
        self.background = self.figure.canvas.copy_from_bbox(self.figure.bbox)

    def draw(self, t):
        """The frame at time t as RGBA bytes."""
        canvas = self.figure.canvas
        canvas.restore_region(self.background)
        u = np.array([np.interp(t, self.run.times, layer) for layer in self.u.T])
        moving = [(self.profile, self.profile.fill_betweenx(self.depth, 0.0, u, color=look.GRAINS, linewidth=0)),
                  (self.profile, self.profile.plot(u, self.depth, color=look.INK)[0]),
                  (self.profile, self.profile.text(0.03, 0.05, f"t = {look.seconds(t)}", transform=self.profile.transAxes, fontsize=16)),
                  (self.speed, self.speed.axvline(t, color=look.ACCENT, linewidth=1.5))]
        for axes, artist in moving:
            axes.draw_artist(artist)
        frame = bytes(canvas.buffer_rgba())
        for _, artist in moving:
            artist.remove()
        return frame
