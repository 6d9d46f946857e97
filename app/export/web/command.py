"""`halfway export`: steps as pages that open in any browser, with a still beside each and an index of the course."""

import sys
from argparse import ArgumentParser, BooleanOptionalAction, Namespace
from dataclasses import replace
from io import BytesIO
from pathlib import Path

from PIL import Image

from app import VERSION
from app.catalog import LoadedStep, chapters, step, steps
from app.export import target
from app.export.gallery import progress
from app.export.markup import anchor
from app.export.png import png
from app.export.web import index
from app.export.web.content import content
from app.export.web.moving import moving
from app.export.web.page import file_of, page
from app.lesson import Study
from app.problem import Problem, Usage
from app.state import defaults, parse, write
from app.theme import THEMES

POSTER, SMALL, PLOT, SQUARE = (1280, 720), (800, 450), (900, 600), (360, 360)
DARK = THEMES["dark"]
LOOK = 0.2  # s for a study


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("steps", nargs="*", metavar="STEP", help="chapter/step, or a whole chapter")
    parser.add_argument("--all", action="store_true", help="every step of the course")
    parser.add_argument("-o", "--output", metavar="DIR", required=True, help="the folder the pages go to")
    parser.add_argument("--poster", action=BooleanOptionalAction, default=True,
                        help="a still beside each page and in it, for slides and browsers without WebGL2")
    parser.add_argument("--film", action=BooleanOptionalAction,
                        help="a film (GIF) beside each page, for slides: a second a step, with --all if asked for")


def run(options: Namespace) -> int:
    todo = wanted(options.steps, options.all)
    folder = target.make_folder(options.output)
    film = options.poster and not options.all if options.film is None else options.film
    done: list[LoadedStep] = []
    faults: list[str] = [] if options.steps else [loaded.fault for loaded in chapters() if loaded.fault]
    stopped = False
    try:
        with progress(len(todo)) as tell:
            for i, found in enumerate(todo):
                tell(i, found.step.title)
                try:
                    export(found, folder, options.poster)
                    if film and (made := moving(found)):
                        target.write(folder / f"{anchor(found.id)}.gif", made)
                    done.append(found)
                except Problem as problem:
                    faults.append(f"{found.id}: {problem}")
    except KeyboardInterrupt:
        stopped = True
    target.write(folder / "index.html", index.page(done, options.poster).encode("utf-8"))
    for fault in faults:
        print(f"halfway: {fault}", file=sys.stderr)
    said = f"{'Stopped early. ' if stopped else ''}{len(done)} of {len(todo)} pages."
    print(f"{said} Open {(folder / 'index.html').resolve()}")
    return 1 if faults or stopped else 0


def wanted(names: list[str], everything: bool) -> list[LoadedStep]:
    """The steps that are named, by their own name or their chapter's; each once, in the order of the course."""
    if everything or not names:
        if names or not everything:
            raise Usage("name the steps to export, or --all for the whole course.")
        return list(steps())
    whole = {loaded.id for loaded in chapters()}
    ids = {found.id for name in names for found in
           ([s for s in steps() if s.loaded.id == name] if name in whole else [step(parse(name).step)])}
    return [found for found in steps() if found.id in ids]


def export(found: LoadedStep, folder: Path, poster: bool) -> None:
    """One step's page, and its still."""
    data = content(found)
    small, stills = None, {}
    if poster:
        from app.export.shooting import Shooting, framed
        from app.export.still import data as carried

        values: dict = defaults(found)
        values |= carried(found, values)
        with Shooting(found, POSTER, DARK) as one:
            camera, seen = one.camera([values], None), data["scene"]["camera"]
            picture, seen["wide"] = one.picture(values, camera), camera.field_of_view
            # what fills a square picture fits into any
            seen["field_of_view"] = framed(one.stage(values), values, SQUARE, DARK).field_of_view
        small = webp(picture.resize(SMALL, Image.Resampling.LANCZOS))
        stills = {i: webp(still_of(found, values, i)) for i, p in enumerate(data["plots"]) if p["kind"] == "still"}
        words = {"Title": found.step.title, "Software": f"Halfway {VERSION}", "halfway:state": write(found, values)}
        target.write(folder / f"{anchor(found.id)}.png", png(picture, words))
    target.write(folder / file_of(found.id), page(found, data, small, stills).encode("utf-8"))


def still_of(found: LoadedStep, values: dict, number: int) -> Image.Image:
    """A plot that cannot live in a page; of a study what a short look measures."""
    from app.export.still import plotted
    from app.plots.efforts import whole
    from app.study.measure import measure

    plot = found.step.plots[number]
    if isinstance(plot, Study):
        study = replace(plot, worst={})
        return whole(study, measure(study, values, LOOK), PLOT, DARK)
    return plotted(found, values, PLOT, DARK, number)


def webp(picture: Image.Image) -> bytes:
    out = BytesIO()
    picture.save(out, "WEBP", quality=72)
    return out.getvalue()


