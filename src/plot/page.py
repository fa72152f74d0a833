"""One self-contained HTML page: text, tables, pictures inside it, and an animation that can be scrubbed. No network, no other file."""

import base64
import html
import json
from pathlib import Path

HERE = Path(__file__).resolve().parent
TYPES = {".png": "image/png", ".webp": "image/webp"}


def text(words):
    """Words made safe for HTML."""
    return html.escape(str(words))


def data_uri(content, suffix):
    return f"data:{TYPES[suffix]};base64,{base64.b64encode(content).decode()}"


def picture(path, caption, number=None):
    """A figure with its picture inside the page. The caption is HTML."""
    name = f"<b>Figure {number}.</b> " if number is not None else ""
    return (f'<figure id="{text(path.stem)}"><img alt="{text(path.stem.replace("_", " "))}" src="{data_uri(path.read_bytes(), path.suffix)}">'
            f"<figcaption>{name}{caption}</figcaption></figure>")


def table(head, rows, kind=""):
    """Cells are HTML. A table wider than the page scrolls by itself."""
    line = lambda cells, tag: "<tr>" + "".join(f"<{tag}>{cell}</{tag}>" for cell in cells) + "</tr>"
    top = f"<thead>{line(head, 'th')}</thead>" if head else ""
    return (f'<div class="wide"><table class="{kind}">{top}<tbody>' + "".join(line(row, "td") for row in rows)
            + "</tbody></table></div>")


def facts(pairs):
    """Names and values, HTML both, in as many columns as the page has room for."""
    return '<dl class="pairs">' + "".join(f"<div><dt>{name}</dt><dd>{value}</dd></div>" for name, value in pairs) + "</dl>"


def beside(*parts):
    """Parts next to each other where there is room, each with its title."""
    return '<div class="beside">' + "".join(f"<div><h3>{text(title)}</h3>{content}</div>" for title, content in parts) + "</div>"


def section(name, title, *parts):
    return f'<section id="{name}"><h2>{text(title)}</h2>' + "\n".join(parts) + "</section>"


def folded(title, content):
    """Text as it stands, behind a title to open."""
    return f"<details><summary>{text(title)}</summary><pre>{text(content)}</pre></details>"


def player(frames, clocks, suffix, caption, first=0):
    """An animation: a slider, play and pause, and a clock. `frames` are encoded pictures, `clocks` the words under each; `first` is shown
    until somebody plays it, from its beginning, or moves the slider."""
    uris = [data_uri(frame, suffix) for frame in frames]
    last = len(uris) - 1
    script = (HERE / "player.js").read_text(encoding="utf-8")
    return f"""<figure class="player" id="player">
<img id="frame" alt="frame of the animation" src="{uris[first]}" data-frame="{first}">
<div class="controls"><button id="play" type="button" aria-label="play">&#9654;</button>
<input id="slider" type="range" min="0" max="{last}" value="{first}" step="1" aria-label="time">
<output id="clock">{text(clocks[first])}</output>
<label>speed <select id="rate"><option value="5">slow</option><option value="15" selected>normal</option><option value="30">fast</option></select></label></div>
<figcaption>{caption}</figcaption>
<script type="application/json" id="frames">{json.dumps({"frames": uris, "clocks": clocks})}</script>
<script>{script}</script></figure>"""


def document(title, lead, sections):
    """The whole page. `sections` are (name, title, html); the names become the list of contents."""
    style = (HERE / "page.css").read_text(encoding="utf-8")
    contents = "".join(f'<a href="#{name}">{text(words)}</a>' for name, words, _ in sections)
    body = "\n".join(section(name, words, content) for name, words, content in sections)
    return f"""<!DOCTYPE html>
<html lang="en-GB"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{text(title)}</title><link rel="icon" href="data:,"><style>{style}</style></head>
<body><header>{lead}<nav>{contents}</nav></header><main>{body}</main></body></html>
"""
