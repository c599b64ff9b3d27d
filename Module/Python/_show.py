# SPDX-License-Identifier: BSD-3-Clause
"""A panorama that turns in the cell of a notebook."""

import base64
import html
import json
import os
from typing import Any, Dict, Optional, Tuple

from ._render import render


def _viewer_folder() -> str:
    """Where the viewer of web pages is: share/widefov/web, below a folder that this module is in."""
    places = [os.path.join(os.environ.get("WIDEFOV_DATA_DIR", ""), "web")]
    place = os.path.dirname(os.path.abspath(__file__))
    while place != os.path.dirname(place):
        place = os.path.dirname(place)
        places.append(os.path.join(place, "share", "widefov", "web"))
    for folder in places:
        if os.path.isfile(os.path.join(folder, "viewer.js")):
            return folder
    raise RuntimeError(
        "show: the viewer of panoramas is not installed: it comes with the package widefov, and in a "
        "checkout with Utilities/fetch-viewer.sh")


def _read(folder: str, name: str) -> str:
    with open(os.path.join(folder, name), encoding="utf-8") as stream:
        return stream.read()


def _jpeg(picture: Any) -> bytes:
    """A picture of `render` as a JPEG file."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkJPEGWriter

    height, width, _ = picture.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(picture[::-1].reshape(-1, 3), deep=True))
    writer = vtkJPEGWriter()
    writer.WriteToMemoryOn()
    writer.SetQuality(95)
    writer.SetInputData(image)
    writer.Write()
    return vtk_to_numpy(writer.GetResult()).tobytes()


def _sphere(picture: Any, hfov: Optional[float], vfov: Optional[float], tilt: float) -> Dict[str, float]:
    """The part of the sphere in the picture, by the viewer's names."""
    height, width, _ = picture.shape
    full = (round(width * 360 / (hfov or 360)), round(height * 180 / (vfov or 180)))
    return {
        "fullWidth": full[0], "fullHeight": full[1], "croppedWidth": width, "croppedHeight": height,
        "croppedX": (full[0] - width) // 2, "croppedY": (full[1] - height) // 2, "posePitch": tilt,
    }


class Panorama:
    """What `show` returns: a page, which a notebook shows as HTML. `html`: the text of the page."""

    def __init__(self, page: str, height: int):
        self.html = page
        self.height = height

    def _repr_html_(self) -> str:
        return (
            '<iframe srcdoc="%s" style="border: 0; width: 100%%; height: %dpx" allow="fullscreen" '
            'allowfullscreen></iframe>' % (html.escape(self.html), self.height))


def show(
    data_or_actors: Any, size: Tuple[int, int] = (2048, 1024), *, title: str = "", height: int = 500,
    hfov: Optional[float] = None, vfov: Optional[float] = None, tilt: float = 0, **view: Any,
) -> Panorama:
    """Draws data or actors all round the eye, as a panorama that turns in the cell of a notebook.

    data_or_actors, hfov, vfov, tilt, and what else `render` has of the view: as of `render`; the
    projection is equirectangular. size: of the picture of all directions, pixels. title: a line on
    the panorama; height: of the cell, pixels.

    All is in the cell: nothing is loaded, and no server is needed. Raises what `render` raises, a
    ValueError for another projection, and RuntimeError where the viewer is not installed.
    """
    folder = _viewer_folder()
    if view.get("projection", "equirectangular") != "equirectangular" or abs(tilt) > 90:
        raise ValueError("show: the projection is equirectangular, tilted by at most 90 degrees")
    picture = render(data_or_actors, size=size, hfov=hfov, vfov=vfov, tilt=tilt, **view)
    page = {"title": title, "picture": "panorama.jpg", "sphere": _sphere(picture, hfov, vfov, tilt)}
    data = "data:image/jpeg;base64," + base64.b64encode(_jpeg(picture)).decode()
    script = "%s\nwidefov.file(%s, %s);\nwidefov.show(%s);" % (
        _read(folder, "viewer.js"), json.dumps("panorama.jpg"), json.dumps(data),
        json.dumps(page).replace("</", "<\\/"))
    return Panorama(
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Panorama</title>\n'
        '<style>%s</style></head>\n<body><div id="view"></div>\n<script>%s</script>\n</body></html>\n'
        % (_read(folder, "viewer.css"), script), height)
