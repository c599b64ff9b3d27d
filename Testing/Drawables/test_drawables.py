# SPDX-License-Identifier: BSD-3-Clause
"""Everything that VTK draws, in a wide view: right, or a word.

    test_drawables.py FOLDER props|mappers|representations|widgets|renderpasses|pickers
        [--results FILE.json] [NAME...]

FOLDER has the package widefov. Each thing is drawn in a process of its own. It fails where that ends
by itself or OpenGL notes an error, and where a picture differs from stock VTK's six faces of 90
degrees though nothing was said. What ends a stock renderer's process too is not asked of a wide one.
"""

import json
import sys

SHARE = 0.003  # of what is covered, that may be covered by one picture alone
COLOURS = 0.1  # of what both cover, that may have a colour which is not near in the other: letters

# What has a size in pixels, or is made for the view that it is drawn in: it cannot be the picture of
# six views.
OWN_WAY = {
    "vtkBillboardTextActor3D": "as many pixels large as it is told, its top where `LabelUp` says",
    "vtkFlagpoleLabel": "its label is as many pixels large as it is told, along its pole",
    "vtkLabelPlacementMapper": "as many pixels large as it is told, where its places are seen, tops where `LabelUp` says",
    "vtkLabeledDataMapper": "as many pixels large as it is told, where its places are seen, tops where `LabelUp` says",
    "vtkDynamic2DLabelMapper": "as many pixels large as it is told, where its places are seen, tops where `LabelUp` says",
    "vtkFixedPointVolumeRayCastMapper": "as `vtkGPUVolumeRayCastMapper` draws it (`VolumeKinds`), see [limits](known-limits.md)",
    "vtkCaptionActor2D": "an overlay, beside what it points at",
    "vtkCaptionRepresentation": "an overlay, beside what it points at",
    "vtkCaptionWidget": "an overlay, beside what it points at",
    "vtkAngleRepresentation2D": "an overlay, where its places are seen",
    "vtkDistanceRepresentation2D": "an overlay, where its places are seen",
    "vtkPointHandleRepresentation2D": "an overlay, where its place is seen",
    "vtkRectilinearWipeRepresentation": "an overlay, where its image is seen",
    "vtkRectilinearWipeWidget": "an overlay, where its image is seen",
    "vtkFixedSizeHandleRepresentation3D": "seen, of its size in pixels",
    "vtkMeasurementCubeHandleRepresentation3D": "seen, of its size in pixels",
    "vtkSphereRepresentation": "its text is as many pixels large as it is told, its top where `LabelUp` says",
    "vtkSphereWidget2": "its text is as many pixels large as it is told, its top where `LabelUp` says",
    "vtkResliceCursorLineRepresentation": "turns the camera to its slice in each frame, as in stock VTK",
    "vtkResliceCursorThickLineRepresentation": "turns the camera to its slice in each frame, as in stock VTK",
    "vtkResliceCursorWidget": "turns the camera to its slice in each frame, as in stock VTK",
    "vtkAngleRepresentation3D": "right; its text faces the eye upright all round",
    "vtkDistanceRepresentation3D": "right; its text faces the eye upright all round",
    "vtkFinitePlaneWidget": "right but for the colour of its plane, which is by chance in stock VTK too",
    "vtkPointCloudWidget": "right; its outline shows where the pointer picks it",
    "vtkLegendScaleActor": "an overlay, with a warning: a wide picture has no one scale",
}

# The VTK whose widgets are set beside the six faces.
KNOWN = "9.1."

# What this test draws nothing of.
ELSEWHERE = {
    "vtkMultiVolume": "see [volumes](design/volumes.md): stock VTK 9.1 is no measure of it",
    "vtkAvatar": "nothing to see without a headset",
    "vtkAxesTransformRepresentation": "a line where uninitialized memory says, in stock VTK too",
    "vtkAxesTransformWidget": "a line where uninitialized memory says, in stock VTK too",
    "vtkLabeledTreeMapDataMapper": "labels of a plane tree map, which this test does not make",
    "vtkQtTreeRingLabelMapper": "labels of a plane tree, which this test does not make",
    "vtkOpenGLGlyph3DHelper": "a part of vtkGlyph3DMapper",
}


def verdict(name, result, overlay):
    """What is to be said of a thing, and whether that is wrong."""
    if "crash" in result:
        return "ends the process: %s" % result["crash"], True
    if result["gl"]:
        return "OpenGL notes errors %s" % result["gl"], True
    views = result["views"].values()
    if name in ELSEWHERE:
        return ELSEWHERE[name], False
    if overlay and name not in OWN_WAY:
        return "an overlay, as in any view", False
    if not any(view["stock"] for view in views) and not any(view["wide"] for view in views):
        return "nothing to see, as in stock VTK", False
    worst = max(max(view["missing"], view["added"]) for view in views)
    colour = max(view["colour"] for view in views)
    if worst <= SHARE and colour <= COLOURS:
        return "right", False
    if "left out" in result["said"] and not any(view["wide"] for view in views):
        return "left out, with a warning", False
    if name in OWN_WAY and all(view["wide"] for view in views):
        return OWN_WAY[name], False
    return "differs: %.3g of what is covered, %.3g in colour" % (worst, colour), True


class Things:
    """What is drawn: how it is made, measured and judged."""

    def __init__(self):
        import classes
        import draw
        import passes
        import pickers
        import recipes
        import vtk
        import widgets

        self.classes, self.draw, self.recipes = classes, draw, recipes
        self.vtk, self.widgets = vtk, widgets
        self.own = {"renderpasses": passes, "pickers": pickers}

    def names(self, kind):
        if kind == "mappers":
            made = [n for n in self.recipes.MAPPERS if hasattr(self.vtk, n.split()[0])]
            return made + [n for n in self.classes.mappers() if n not in made]
        if kind == "renderpasses":
            return self.classes.passes()
        if kind == "widgets":
            return self.classes.concrete(self.vtk.vtkAbstractWidget, self.vtk.vtk3DWidget)
        return getattr(self.classes, kind)()

    def version(self):
        return self.vtk.vtkVersion.GetVTKVersion()

    def measure(self, kind, name):
        if kind in self.own:
            return self.own[kind].measure(name)
        if name in ELSEWHERE:
            return {"views": {}, "gl": [], "said": ""}
        if kind in ("props", "mappers"):
            return self.draw.measure(lambda: self.recipes.make(name))
        return self.draw.show(lambda stage: self.put(kind, name, stage))

    def put(self, kind, name, stage):
        if kind == "representations":
            return self.widgets.representation(name, stage.renderer)
        return self.widgets.widget(name, stage)

    def ends_stock(self, kind, name):
        """How a stock renderer does not survive it either; nothing where it does."""
        import forked

        def draw(name):
            if kind in self.own:
                pixels = self.own[kind].show_stock(name)
            elif kind in ("props", "mappers"):
                pixels = self.draw.stock_pixels(lambda: self.recipes.make(name))
            else:
                pixels = self.draw.show_stock(lambda stage: self.put(kind, name, stage))
            return {"pixels": pixels}

        return forked.run(draw, name).get("crash")

    def judge(self, kind, name):
        import forked

        result = forked.run(lambda name: self.measure(kind, name), name, 300)
        stock = self.ends_stock(kind, name) if "crash" in result else None
        if stock:
            return "ends the process of a stock renderer too: %s" % stock, False
        if kind in ("representations", "widgets"):
            return shown(name, result, self.version().startswith(KNOWN))
        if kind in self.own:
            return (result["crash"], True) if "crash" in result else self.own[kind].verdict(result)
        thing = getattr(self.vtk, name.split()[0])
        return verdict(name, result, issubclass(thing, (self.vtk.vtkActor2D, self.vtk.vtkMapper2D)))


def shown(name, result, known):
    """Of what widgets show: what of it is in the plane of the picture is the same wherever one looks.
    known: of the VTK whose widgets have been set beside the six faces. Newer ones have others, many of
    them of a size in pixels; these are to be seen where stock VTK's are."""
    if "crash" in result or result["gl"] or name in ELSEWHERE:
        return verdict(name, result, False)
    views = result["views"].values()
    wide = any(view["wide"] for view in views)
    if known and result["flat"] and wide:
        return "an overlay, as in any view", False
    if known:
        return verdict(name, result, False)
    if any(view["stock"] for view in views) and not wide:
        said = "left out" in result["said"]
        return "left out, with a warning" if said else "is not seen, and nothing was said", not said
    return "seen" if wide else "nothing to see, as in stock VTK", False


def main(folder, kind, *names):
    sys.path.insert(0, folder)
    names = list(names)
    results = None
    if names[:1] == ["--results"]:
        results = names[1]
        names = names[2:]
    import forked

    things = Things()
    names = names or forked.run(lambda kind: things.names(kind), kind)
    wrong = 0
    found = {}
    for name in names:
        found[name], bad = things.judge(kind, name)
        wrong += bad
        print("%-44s %s%s" % (name, "WRONG: " if bad else "", found[name]), flush=True)
    if results:
        with open(results, "w", encoding="utf-8") as file:
            json.dump({"version": things.version(), kind: found}, file, indent=1)
    print("%d of %d are wrong" % (wrong, len(names)))
    return 1 if wrong or not names else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
