"""The one page of a study: which picture belongs to which kind."""

import netCDF4

import converge_page
import trade_page
import wellposed_page

PAGES = {"converge": converge_page.draw, "trade": trade_page.draw, "wellposed": wellposed_page.draw}


def draw(folder, out):
    """Writes study.png of the study.nc in `folder` and returns its path."""
    with netCDF4.Dataset(folder / "study.nc") as data:
        return PAGES[data.study](data, out)
