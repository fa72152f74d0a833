"""What table 2's slopes, and speed profiles like those of figure 7, say of the friction law: tables for fit_table_2.md.

    /usr/bin/python3 runs/studies/fit_table_2.py [--talus build/release/talus] [--out out/fit_table_2]
"""

import argparse
import json
import subprocess
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "runs" / "studies" / "fit"
MATERIAL = ROOT / "runs" / "paper" / "table_2.toml"
BOUNDS = {"mu_s": (0.2, 0.6), "mu_d": (0.45, 3.0), "mu_inf": (0.01, 10.0), "I_0": (0.05, 20.0), "mu_w": (0.1, 1.0)}
FLOWS = (0.0020, 0.0046, 0.0060)


class Study:
    def __init__(self, talus, out):
        self.talus, self.out = talus, out
        out.mkdir(parents=True, exist_ok=True)

    def fit(self, name, unknowns, slopes=None, profiles=(), law="partially_regularised", condition="report"):
        """The answer of talus fit as JSON. profiles: (file, flow)."""
        lines = ["[fit]", f'name = "{name}"', f'material = "{MATERIAL}"', f'set = ["rheology.law={law}"]',
                 f'condition = "{condition}"', "starts = 3"]
        for parameter in unknowns:
            low, high = BOUNDS[parameter]
            lines += ["[[unknown]]", f'parameter = "{parameter}"', f"low = {low}", f"high = {high}"]
        if slopes:
            lines += ["[[slopes]]", f'file = "{slopes}"']
        for path, flow in profiles:
            lines += ["[[profile]]", f'file = "{path}"', f"flow = {flow}", "offset_limit = 0.0005"]
        file = self.out / f"{name}.toml"
        file.write_text("\n".join(lines) + "\n")
        done = subprocess.run([self.talus, "fit", file, "--out", self.out / name, "--json"],
                              capture_output=True, text=True)
        if done.returncode == 6:  # no start converged
            return {"exists": False, "reason": done.stderr.strip()}
        done.check_returncode()
        return json.loads(done.stdout)

    def steady(self, flow, points):
        done = subprocess.run([self.talus, "steady", MATERIAL, "--Q", str(flow), "--points", str(points), "--json"],
                              check=True, capture_output=True, text=True)
        return json.loads(done.stdout)["cases"][0]


def estimates(answer):
    columns = {name: answer["unknown"][name]["values"] for name in ("name", "value", "error", "note")}
    parts = []
    for name, value, error, note in zip(*columns.values()):
        if name.startswith("offset"):
            continue
        parts.append(f"{name} = {value:.4g} +- {error:.2g}" if error is not None else f"{name} = {value:.4g} ({note})")
    return "; ".join(parts)


def slopes_table(study, slopes):
    print("| freed | best | slope - measured [deg] | chi2 / freedom | chance of more | K over printed | largest surface I; C = 0 at |")
    print("|---|---|---|---|---|---|---|")
    for law, unknowns in (("partially_regularised", ("mu_w",)), ("partially_regularised", ("mu_inf",)),
                          ("partially_regularised", ("mu_d",)), ("partially_regularised", ("I_0",)),
                          ("partially_regularised", ("mu_w", "mu_inf")), ("partially_regularised", ("mu_w", "mu_d")),
                          ("partially_regularised", ("mu_d", "mu_inf")), ("partially_regularised", ("mu_d", "I_0")),
                          ("partially_regularised", ("mu_d", "mu_inf", "mu_w")),
                          ("classical", ("mu_w",)), ("classical", ("I_0",)), ("classical", ("mu_d",)),
                          ("classical", ("mu_d", "I_0"))):
        words = ", ".join("K (mu_w)" if u == "mu_w" else u for u in unknowns)
        if law == "classical":
            words = "classical: " + words
        answer = study.fit(f"{Path(slopes).stem}_{law}_{'_'.join(unknowns)}", unknowns, slopes=slopes, law=law)
        if not answer["exists"]:
            print(f"| {words} | {answer['reason'].split('the first: ')[-1]} | | | | | |")
            continue
        data, margin = answer["data"], answer["margin"]
        off = [m - v for m, v in zip(data["model"]["values"], data["measured"]["values"])]
        name = answer["unknown"]["name"]["values"]
        factor = (0.3727 / answer["unknown"]["value"]["values"][name.index("mu_w")]) ** 2.5 if "mu_w" in name else 1.0
        I, room = margin["I"]["values"][-1], margin["C_margin"]["values"][-1]
        bound = f"{I + room:.3g}" if room is not None else "nowhere"
        print(f"| {words} | {estimates(answer)} | {' '.join(f'{x:+.2f}' for x in off)} | {answer['chi2']:.3g} / {answer['freedom']} "
              f"| {answer['chance_of_more']:.2g} | {factor:.3f} | {I:.3g}; {bound} |")


def made_data(study, seed=1, points=12, share=0.03, slope_error=0.5):
    """Slopes that table 2 gives, with normal errors of half a degree, and speeds at twelve depths, of 3 % of the surface speed."""
    random = np.random.default_rng(seed)
    files, slopes = [], []
    for flow in FLOWS:
        case = study.steady(flow, 2001)
        depth, speed = np.array(case["profile"]["depth_m"]), np.array(case["profile"]["speed_m_s"])
        at = np.linspace(2e-4, 5e-3, points)
        error = share * speed[0]
        measured = np.interp(at, depth, speed) + error * random.standard_normal(points)
        path = study.out / f"profile_{1e3 * flow:.1f}.csv"
        rows = [f"{h:.6g},{u:.6g},{error:.4g}" for h, u in zip(at, measured)]
        path.write_text("\n".join(["# made from table 2, with normal errors", "depth_m,speed_m_s,speed_error_m_s", *rows]) + "\n")
        files.append((path, flow))
        slopes.append(f"{flow},0,{case['zeta_deg'] + slope_error * random.standard_normal():.4f},{slope_error}")
    header = "# made from table 2, with normal errors\nQ_kg_s,Q_error_kg_s,zeta_deg,zeta_error_deg\n"
    one, three = study.out / "slope_4.6.csv", study.out / "slopes.csv"
    one.write_text(header + slopes[1] + "\n")
    three.write_text(header + "\n".join(slopes) + "\n")
    return (one, files[1:2]), (three, files)


def profiles_table(study):
    one, three = made_data(study)
    print("| data | unknown | estimates (truth: mu_s 0.4, mu_d 0.9, mu_inf 1.3, I_0 1.3, mu_w 0.3727) | chi2 / freedom |")
    print("|---|---|---|---|")
    for words, (slopes, which) in (("one slope and profile, 4.6 g/s", one), ("three", three)):
        for unknowns in (("mu_d", "mu_w"), ("mu_s", "mu_d", "mu_w"), ("mu_d", "mu_inf", "I_0", "mu_w"), ("mu_s", "mu_d", "mu_inf", "I_0", "mu_w")):
            answer = study.fit(f"profiles_{len(which)}_{len(unknowns)}", unknowns, slopes=slopes, profiles=which)
            print(f"| {words} | {len(unknowns)} | {estimates(answer)} | {answer['chi2']:.3g} / {answer['freedom']} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--talus", type=Path, default=ROOT / "build" / "release" / "talus")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "fit_table_2")
    options = parser.parse_args()
    study = Study(options.talus.resolve(), options.out.resolve())
    print("Measured slopes\n")
    slopes_table(study, DATA / "table_2_slopes.csv")
    print("\nSlopes printed as the paper's fit\n")
    slopes_table(study, DATA / "table_2_printed.csv")
    print("\nSpeed profiles\n")
    profiles_table(study)


if __name__ == "__main__":
    main()
