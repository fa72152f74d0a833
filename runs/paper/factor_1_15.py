"""Which slip would give the angles that table 2 prints? Prints the tables of factor_1_15.md.

    /usr/bin/python3 runs/paper/factor_1_15.py        (python3-numpy; three seconds)

Each hypothesis changes one thing in the exact steady flow (paper sections 4.1 and 4.2) and is held against the three printed angles.
The flow is written down anew here, because most hypotheses are formulas that Talus rightly does not have; as printed it must agree
with the references of models/steady.
"""

import itertools
import math
import re
from dataclasses import dataclass, replace

import numpy as np

ANGLES = (43.3769, 47.9899, 49.5276)        # degree, zeta_fit
FLUXES = (0.0020, 0.0046, 0.0060)           # kg/s, as printed with them
HALF_DIGIT = 5e-5                           # kg/s, half of their last digit
EXACT = (0.00174555323578569, 0.00400214432769221, 0.00518326282435321)  # kg/s at ANGLES for table 2, 25-digit quadrature
TILT = 29.2                                 # degree
X, WEIGHT = np.polynomial.legendre.leggauss(48)


@dataclass(frozen=True)
class Table:
    """Table 2; rho_star is printed in table 1 only."""
    mu_s: float = 0.4
    mu_d: float = 0.9
    mu_inf: float = 1.3
    I_0: float = 1.3
    I_N: float = 0.05178
    alpha: float = 1.9
    mu_w: float = 0.3727
    W: float = 0.003
    Phi: float = 0.6
    d: float = 0.00073
    g: float = 9.81
    rho_star: float = 2500.0


PRINTED = Table()
FIGURE_20 = Table(mu_s=0.342, mu_d=0.557, mu_inf=0.05, I_0=0.069, I_N=0.004, mu_w=0.277, W=0.04, d=0.008)  # table 1, but W, mu_w, d
FIGURE_20_FLUXES = {41: 0.1051, 47: 0.5007, 51: 1.2047, 54: 2.2171, 57: 3.9787, 59: 5.8308}  # m2/s, as printed


def mu_at_I_N(t):
    return (t.mu_s * t.I_0 + t.mu_d * t.I_N + t.mu_inf * t.I_N ** 2) / (t.I_0 + t.I_N)


def inertial_number(mu, t=PRINTED, creep=1.0):
    """Inverse of (3.19); `creep` multiplies A."""
    mu_N = mu_at_I_N(t)
    b = mu - t.mu_d
    fast = (b + np.sqrt(b * b + 4.0 * t.mu_inf * t.I_0 * np.maximum(mu - t.mu_s, 0.0))) / (2.0 * t.mu_inf)
    slow = creep * t.I_N * np.exp(t.alpha / mu_N ** 2 - t.alpha / mu ** 2)
    return np.where(mu > mu_N, fast, slow)


def flux(zeta, t=PRINTED, creep=1.0, cap=math.inf, slip=0.0, cos_power=0.5):
    """Mass flow (4.13) [kg/s] at zeta [degree], as an integral over x = sqrt(depth), in which the shear rate is smooth, split at I_N.

    cap: eta_max [Pa s]; slip: speed at the foot of the layer [m/s]; cos_power: power of cos(zeta) in the shear rate."""
    tan, cos = math.tan(math.radians(zeta)), math.cos(math.radians(zeta))
    rho = t.Phi * t.rho_star
    foot, split = math.sqrt(tan * t.W / t.mu_w), math.sqrt(max(tan - mu_at_I_N(t), 0.0) * t.W / t.mu_w)
    panels = 1 if math.isinf(cap) else 60  # a cap puts a kink of its own into the shear rate
    edges = np.concatenate([np.linspace(0.0, split, panels + 1), np.linspace(split, foot, panels + 1)[1:]])
    half = np.diff(edges)[:, None] / 2.0
    x = edges[:-1, None] + half * (1.0 + X)
    mu = tan - t.mu_w / t.W * x * x
    shear = inertial_number(mu, t, creep) / t.d * math.sqrt(t.Phi * t.g) * cos ** cos_power * x
    shear = np.maximum(shear, rho * t.g * cos * x * x * mu / cap)
    return rho * t.W * (slip * foot ** 2 + float(np.sum(half * WEIGHT * shear * 2.0 * x ** 3)))


def sampled(zeta, n, last=0.5):
    """The mass flow from the speed at n equal steps of depth: trapezoidal rule, or the upper sum with last = 1."""
    tan, cos = math.tan(math.radians(zeta)), math.cos(math.radians(zeta))
    foot = tan * PRINTED.W / PRINTED.mu_w
    fine = (np.arange(200 * n)[::-1] + 0.5) * foot / (200 * n)  # midpoints, from the foot up
    shear = inertial_number(tan - PRINTED.mu_w / PRINTED.W * fine) / PRINTED.d * np.sqrt(PRINTED.Phi * PRINTED.g * cos * fine)
    u = np.cumsum(shear)[199::200] * foot / (200 * n)
    return PRINTED.Phi * PRINTED.rho_star * PRINTED.W * foot / n * (u.sum() - (1.0 - last) * u[-1])


def interpolated(zeta, step):
    """The mass flow from a table of it every `step` degrees."""
    low = step * math.floor(zeta / step)
    return flux(low) + (flux(low + step) - flux(low)) * (zeta - low) / step


def slope(target, function):
    """Slope [degree] at which a flux function has the target [kg/s]."""
    low, high = 25.0, 70.0
    for _ in range(45):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < target else (low, middle)
    return 0.5 * (low + high)


def misses(function):
    """How far the fluxes at the printed angles lie from the stated ones, in half digits: within +-1 they round to them."""
    return [(function(angle) - Q) / HALF_DIGIT for angle, Q in zip(ANGLES, FLUXES)]


def worst(function):
    return max(abs(m) for m in misses(function))


def best(family, low, high):
    """The value of a one-parameter family with the least worst miss: a scan, narrowed down."""
    for _ in range(6):
        values = np.linspace(low, high, 25)
        k = int(np.argmin([worst(family(v)) for v in values]))
        low, high = values[max(k - 1, 0)], values[min(k + 1, 24)]
    return 0.5 * (low + high)


def neutral_point(t):
    """Upper zero of C (3.18) on the rational branch: printed 1.0297."""
    def C(I):
        mu = (t.mu_s * t.I_0 + t.mu_d * I + t.mu_inf * I * I) / (t.I_0 + I)
        nu = I * ((t.mu_d + 2.0 * t.mu_inf * I) - mu) / (t.I_0 + I) / mu
        return (mu * (1.0 - nu / 2.0)) ** 2 - 4.0 * nu * (1.0 - nu)
    low, high = 0.3, 20.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if C(middle) < 0.0 else (low, middle)
    return low


def largest_classical_flux(t):
    """Closed form at tan zeta = mu_d [kg/s]; the text wants it below 0.0046."""
    cos = 1.0 / math.sqrt(1.0 + t.mu_d ** 2)
    prefactor = t.Phi * t.rho_star * t.W * t.I_0 / t.d * math.sqrt(t.Phi * t.g * cos)
    return prefactor * 4.0 / 15.0 * ((t.mu_d - t.mu_s) * t.W / t.mu_w) ** 2.5


def against_the_text(t):
    """What else the paper prints that the changed table breaks."""
    faults = []
    if abs(neutral_point(t) - 1.0297) > 5e-5:
        faults.append(f"C = 0 at {neutral_point(t):.4f}, printed 1.0297")
    if largest_classical_flux(t) > FLUXES[1]:
        faults.append(f"classical law reaches {1e3 * largest_classical_flux(t):.2f} g/s, text: less than 4.6")
    I = float(inertial_number(math.tan(math.radians(ANGLES[2])), t))
    if I > 1.0297:
        faults.append(f"surface I = {I:.3f}, figure 10(b): below 1.0297")
    return "; ".join(faults)


def changed(name):
    return lambda value: lambda zeta: flux(zeta, replace(PRINTED, **{name: value}))


def scaled(factor):
    return lambda zeta: factor * flux(zeta)


def one_parameter_families():
    """(words, family, low, high, unit factor, changed entry of the table or None)"""
    table = [("W, in friction and flux [mm]", "W", 0.0028, 0.0034, 1e3), ("mu_w", "mu_w", 0.3, 0.42, 1.0),
             ("d [mm]", "d", 5e-4, 9e-4, 1e3), ("rho_star [kg/m3]", "rho_star", 2200.0, 3300.0, 1.0),
             ("Phi, in density and shear", "Phi", 0.5, 0.74, 1.0), ("mu_inf", "mu_inf", 0.6, 1.6, 1.0), ("I_0", "I_0", 1.0, 2.0, 1.0),
             ("mu_d", "mu_d", 0.6, 1.0, 1.0), ("mu_s", "mu_s", 0.3, 0.45, 1.0)]
    for words, name, low, high, unit in table:
        yield words, changed(name), low, high, unit, name
    yield "factor on the flux", scaled, 1.0, 1.4, 1.0, None
    friction_only = lambda v: lambda z: flux(z, replace(PRINTED, W=v)) * PRINTED.W / v
    yield "W in wall friction only [mm]", friction_only, 0.0028, 0.0036, 1e3, None
    yield "W in the flux only [mm]", lambda v: scaled(v / PRINTED.W), 0.0028, 0.0038, 1e3, None
    yield "Phi in the shear only", lambda v: lambda z: flux(z, replace(PRINTED, Phi=v)) * PRINTED.Phi / v, 0.5, 0.95, 1.0, None
    yield "power of cos zeta in the shear", lambda v: lambda z: flux(z, cos_power=v), -0.5, 1.0, 1.0, None
    yield "viscosity cap eta_max [Pa s]", lambda v: lambda z: flux(z, cap=v), 0.2, 200.0, 1.0, None
    yield "speed at the foot [mm/s]", lambda v: lambda z: flux(z, slip=v), 0.0, 0.03, 1e3, None
    yield "factor on A of the creep branch", lambda v: lambda z: flux(z, creep=v), 1.0, 40.0, 1.0, None


def hypotheses_without_a_parameter():
    def section(angle):
        return lambda z: flux(z) / math.cos(math.radians(angle(z)))
    yield "as printed", flux
    yield "2/sqrt(3) on the flux", scaled(2.0 / math.sqrt(3.0))
    for words, factor in (("I = 2 sqrt(tr D^2) d/...: norm without 1/2", math.sqrt(0.5)), ("I = D_norm d/...: no factor 2", 2.0),
                          ("I with rho for rho_*", PRINTED.Phi ** -0.5), ("flux with rho_*", 1.0 / PRINTED.Phi),
                          ("both of these", PRINTED.Phi ** -1.5), ("flux of a parabola across the gap, 2/3", 2.0 / 3.0),
                          ("d = 0.71 mm, lower sieve", 0.73 / 0.71)):
        yield words, scaled(factor)
    yield "p = rho g z: no cos zeta in the shear", lambda z: flux(z, cos_power=0.0)
    yield "... nor in the wall friction's p", lambda z: flux(z, cos_power=0.0) * math.cos(math.radians(z)) ** 2.5
    yield "one wall only", changed("mu_w")(PRINTED.mu_w / 2.0)
    yield "speed over the vertical depth", section(lambda z: z)
    yield "speed over the depth normal to the box", section(lambda z: z - TILT)
    yield "1/cos(29.2 deg)", section(lambda z: TILT)
    yield "mu_w = 0.27 (table 1)", changed("mu_w")(0.27)
    yield "mu_w = 0.277 (figure 20)", changed("mu_w")(0.277)
    yield "mu_s = tan 22 deg", changed("mu_s")(math.tan(math.radians(22.0)))
    yield "mu_d and mu_inf exchanged", lambda z: flux(z, replace(PRINTED, mu_d=1.3, mu_inf=0.9))
    yield "I_N from the classical law, not rounded", changed("I_N")(0.051781830056348)
    yield "no creep below I_N", lambda z: flux(z, creep=0.0)
    yield "Phi, d, mu_w, g each off by half a digit", lambda z: flux(z, replace(PRINTED, Phi=0.65, d=0.000725, mu_w=0.37265, g=9.815))
    yield "mu_inf = 0.9", changed("mu_inf")(0.9)
    for n in (10, 20, 40):
        yield f"trapezoidal rule, {n} steps", lambda z, n=n: sampled(z, n)
    yield "linear in a table of Q every 5 degrees", lambda z: interpolated(z, 5.0)
    yield "upper sum, 11 steps", lambda z: sampled(z, 11, last=1.0)


def misprints():
    """Each printed value with one digit changed: (words, table) of those that rounding covers or nearly, and how many were tried."""
    digits = {"mu_s": "0.4", "mu_d": "0.9", "mu_inf": "1.3", "I_0": "1.3", "I_N": "0.05178", "alpha": "1.9", "mu_w": "0.3727",
              "W": "0.003", "Phi": "0.6", "d": "0.00073", "g": "9.81", "rho_star": "2500"}
    hits, tried = [], 0
    for name, text in digits.items():
        for place in (m.start() for m in re.finditer(r"\d", text)):
            for digit in "0123456789":
                value = float(text[:place] + digit + text[place + 1:])
                t = replace(PRINTED, **{name: value})
                if digit == text[place] or value <= 0.0 or t.mu_s >= t.mu_d or t.Phi > 0.75:
                    continue
                tried += 1
                if worst(lambda z: flux(z, t)) <= 1.05:
                    hits.append((f"{name} = {value:g}, printed {text}", t))
    return hits, tried


def plausible_constants():
    """Products of small powers of 2, 3, pi and Phi: how many lie within a factor 2 of 1, and how many of these in the interval."""
    low, high = factor_interval()
    powers = itertools.product(range(-4, 5), range(-2, 3), range(-2, 3), (-2, 0, 2))  # in halves
    values = [2.0 ** (a / 2) * 3.0 ** (b / 2) * PRINTED.Phi ** (c / 2) * math.pi ** (e / 2) for a, b, c, e in powers]
    near = [v for v in values if 0.5 <= v <= 2.0]
    return len(near), sum(low <= v <= high for v in near)


def factor_interval():
    """Constant factors on the flux that all three rounded fluxes allow."""
    exact = [flux(angle) for angle in ANGLES]
    return max((Q - HALF_DIGIT) / q for Q, q in zip(FLUXES, exact)), min((Q + HALF_DIGIT) / q for Q, q in zip(FLUXES, exact))


def row(words, function, value="", text=""):
    off = [slope(Q, function) - angle for Q, angle in zip(FLUXES, ANGLES)]
    cells = [words, value, " ".join(f"{function(a) / Q:.3f}" for a, Q in zip(ANGLES, FLUXES)), " ".join(f"{x:+.2f}" for x in off),
             f"{math.sqrt(sum(x * x for x in off) / 3.0):.3f}", f"{worst(function):.2f}", text]
    return worst(function), "| " + " | ".join(cells) + " |"


def main():
    for angle, exact in zip(ANGLES, EXACT):
        assert abs(flux(angle) / exact - 1.0) < 1e-9, f"flux as printed at {angle}"
    low, high = factor_interval()
    print(f"factor on the flux that rounding allows: {low:.4f} to {high:.4f}; needed at each angle if Q is exact:",
          " ".join(f"{Q / flux(a):.4f}" for a, Q in zip(ANGLES, FLUXES)))
    print("figure 20, exact/printed - 1:", " ".join(f"{flux(angle, FIGURE_20) / (1500.0 * 0.04) / Q - 1.0:+.1e}"
                                                    for angle, Q in FIGURE_20_FLUXES.items()))
    head = "| {} | {} | flux / stated Q | slope - printed [deg] | rms | worst miss | against the text |\n|---|---|---|---|---|---|---|"
    print("\nOne parameter, best value\n" + head.format("freed", "best value"))
    rows = []
    for words, family, lower, upper, unit, name in one_parameter_families():
        value = best(family, lower, upper)
        text = against_the_text(replace(PRINTED, **{name: value})) if name else ""
        rows.append(row(words, family(value), f"{value * unit:.4g}", text))
    print("\n".join(line for _, line in sorted(rows)))
    hits, tried = misprints()
    rows = [row(words, function) for words, function in hypotheses_without_a_parameter()]
    rows += [row(words, lambda z, t=t: flux(z, t), text=against_the_text(t)) for words, t in hits]
    print("\nWithout a parameter\n" + head.format("hypothesis", ""))
    print("\n".join(line for _, line in sorted(rows)))
    print(f"\none digit misprinted: {tried} values tried, {len(hits)} in the table above")
    print("products of small powers of 2, 3, pi, Phi between 1/2 and 2, and in the interval:", *plausible_constants())


if __name__ == "__main__":
    main()
