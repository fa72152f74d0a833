"""Printed numbers beside ours: rows of the table that the reproduction of the paper ends in."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    where: str        # figure, table, section or equation of the paper
    what: str
    printed: str
    ours: str
    difference: str
    reason: str = ""

    def cells(self):
        return [self.where, self.what, self.printed, self.ours, self.difference, self.reason]


HEAD = Row("where", "what", "paper", "here", "difference", "reason").cells()


def compare(where, what, printed, ours, unit="", reason="", digits=5):
    """A row for a printed number, given as it is printed, and ours. The difference is in degrees for angles, in per cent of the print
    else; where ours rounds to the print there is neither that nor a reason."""
    decimals = len(printed.partition(".")[2])
    off = ours - float(printed)
    if f"{ours:.{decimals}f}" == printed:
        difference, reason = "rounds to it", ""
    elif unit == "deg":
        difference = f"{off:+.2f}"
    else:
        percent = 100.0 * off / float(printed)
        difference = f"{percent:+.2g} %" if abs(percent) < 10.0 else f"{percent:+.0f} %"
    suffix = f" {unit}" if unit else ""
    return Row(where, what, printed + suffix, f"{ours:.{digits}g}" + suffix, difference, reason)


def markdown(rows):
    """The table as a list of lines."""
    lines = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
    return lines + ["| " + " | ".join(row.cells()) + " |" for row in rows]
