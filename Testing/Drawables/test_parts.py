# SPDX-License-Identifier: BSD-3-Clause
"""Props within props, and what is said of them.

    test_parts.py FOLDER [NAME...]

FOLDER has the package widefov. Each in a process of its own, which may end by itself.
"""

import math
import sys


def sky(textured=True):
    import vtk
    from recipes import texture

    made = vtk.vtkSkybox()
    made.SetProjectionToSphere()
    if textured:
        made.SetTexture(texture())
    return made


def whole(kind, *parts):
    import vtk

    made = getattr(vtk, kind)()
    for part in parts:
        made.AddPart(part)
    return made


def ball():
    import materials

    return materials.actor_of(materials.ball(0.7, (0, 0, 0)))


def shortened():
    """An actor whose strips have a point each."""
    import vtk

    points = vtk.vtkPoints()
    strips = vtk.vtkCellArray()
    for i in range(4):
        strips.InsertNextCell(1, [points.InsertNextPoint(i, 0, 0)])
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetStrips(strips)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    return made


def picture(*props):
    """What is drawn, and what was said."""
    import vtk

    import draw

    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = draw.wide_stage()
    for prop in props:
        stage.add(prop)
    stage.draw()
    drawn = stage.draw()
    return drawn, heard.GetOutput(), draw.gl_errors()


def differing(a, b):
    return float((abs(a - b).max(-1) > 2).mean())


def check_alike(parts, instead, word):
    """Parts of assemblies of both kinds beside the same props in the scene itself."""
    plain, _, _ = picture(*instead())
    faults = []
    for kind in ("vtkPropAssembly", "vtkAssembly"):
        drawn, said, errors = picture(whole(kind, *parts()))
        if errors:
            faults.append("%s: OpenGL notes errors %s" % (kind, errors))
        if differing(plain, drawn) > 0:
            faults.append("%s: %.3g of the pixels differ" % (kind, differing(plain, drawn)))
        if bool(said) != bool(word) or (word and word not in said):
            faults.append("%s: %r is said" % (kind, said))
        word = None  # once a process
    return faults


def sky_in_assembly():
    return check_alike(lambda: (sky(), ball()), lambda: (sky(), ball()), None)


def bare_sky_in_assembly():
    return check_alike(lambda: (sky(False), ball()), lambda: (ball(),), "without a texture")


def short_strips_in_assembly():
    return check_alike(lambda: (shortened(), ball()), lambda: (ball(),), "strips")


def text():
    import recipes

    return recipes.vtkBillboardTextActor3D()


def text_in_assembly():
    return check_alike(lambda: (ball(), text()), lambda: (ball(), text()), None)


def follower(bearing):
    """A strip that begins at its place, as letters do."""
    import vtk

    import draw

    source = vtk.vtkPlaneSource()
    source.SetOrigin(0, 0, 0)
    source.SetPoint1(4, 0, 0)
    source.SetPoint2(0, 0.5, 0)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    made = vtk.vtkFollower()
    made.SetMapper(mapper)
    a = math.radians(bearing)
    made.SetPosition(3 * math.sin(a), 0, draw.DISTANCE - 3 * math.cos(a))
    return made


def follower_at_the_rim():
    """Its bounds are of the way that it was turned before."""
    import draw

    faults = []
    for bearing in (-95, -100, -110):
        counts = []
        for culls in (True, False):
            stage = draw.wide_stage()
            camera = stage.renderer.GetActiveCamera()
            camera.SetProjection("azimuthal-equidistant")
            camera.SetHorizontalFieldOfView(180)
            camera.SetVerticalFieldOfView(180)
            stage.renderer.GetPass().SetCulling(culls)
            stage.add(follower(bearing))
            stage.draw()
            counts.append(int(draw.covered(stage.draw()).sum()))
        if counts[0] != counts[1] or not counts[1]:
            faults.append("%d degrees: %d pixels culled, %d not" % (bearing, *counts))
    return faults


def window_given_back():
    """A pass over the picture round stock VTK's steps, with a gradient by direction."""
    import vtk

    import draw

    stage = draw.wide_stage()
    stage.add(ball())
    stage.renderer.SetBackground2(0.9, 0.1, 0.1)
    stage.renderer.GradientBackgroundOn()
    stage.renderer.GradientByDirectionOn()
    blur = vtk.vtkGaussianBlurPass()
    blur.SetDelegatePass(vtk.vtkRenderStepsPass())
    stage.renderer.SetPass(blur)
    first = stage.draw()
    stage.window.Finalize()
    return ["%.3g of the pixels differ" % differing(first, stage.draw())] * (
        differing(first, stage.draw()) > 0
    )


def innocent():
    """Of a prop whose parts were made before the module was there, one that is right is not named."""
    import vtk

    cube = vtk.vtkAnnotatedCubeActor()
    import draw

    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = draw.wide_stage()
    for prop in (cube, sky(), ball(), follower(0)):
        stage.add(prop)
    stage.draw()
    stage.draw()
    said = heard.GetOutput()
    right = "vtkAnnotatedCubeActor" in said and "kybox" not in said and "ollower" not in said
    return [] if right and said.count("Warning:") == 1 else ["%r is said" % said]


CASES = {
    "a sky in an assembly": sky_in_assembly,
    "a sky without a texture in an assembly": bare_sky_in_assembly,
    "strips of one point in an assembly": short_strips_in_assembly,
    "a text in an assembly": text_in_assembly,
    "a follower at the rim of a fisheye": follower_at_the_rim,
    "a window that is given back and used again": window_given_back,
    "a warning of what is left out": innocent,
}


def main(folder, *names):
    sys.path.insert(0, folder)
    import forked

    return forked.judge_all(names or CASES, lambda name: CASES[name]())


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
