# SPDX-License-Identifier: BSD-3-Clause
"""Calibrations that cannot be: the files, and the rows that name them."""

DONE, FAILED, USAGE = 0, 1, 2


def yaml(matrix="[30, 0, 32, 0, 30, 16, 0, 0, 1]", lens="[0, 0, 0, 0]", width="64", more="", rows=None):
    """A calibration as OpenCV writes it."""
    return (
        "%%YAML:1.0\n---\nimage_width: %s\nimage_height: 32\n%s"
        "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: %s\n"
        "distortion_coefficients: !!opencv-matrix\n   rows: %s\n   cols: 1\n   dt: d\n   data: %s\n"
    ) % (width, more, matrix, rows or lens.count(",") + 1, lens)


KALIBR = ("%s:\n  camera_model: pinhole\n  intrinsics: [30, 30, 32, 16]\n  distortion_model: radtan\n"
          "  distortion_coeffs: [0, 0, 0, 0]\n  resolution: [64, 32]\n")
COLMAP = "# cameras\n1 PINHOLE 64 32 30 30 32 16\n2 OPENCV_FISHEYE 64 32 30 30 32 16 0 0 0 0\n"


def lens_files():
    """File name -> text."""
    return {
        "lens.yml": yaml(),
        "lens-uneven.yml": yaml(lens="[0.01, 0, 0.01, 0.01]"),
        "lens-turns.yml": yaml(lens="[-1.5, 0, 0, 0]"),
        "lens-turns-unevenly.yml": yaml(lens="[-1.5, 0, 0.01, 0]"),
        "lens-nan.yml": yaml(lens="[.nan, 0, 0, 0]"),
        "lens-word.yml": yaml(lens="[a, 0, 0, 0]"),
        "lens-prism.yml": yaml(lens="[0, 0, 0, 0, 0, 0, 0, 0, 0.1, 0, 0, 0]"),
        "lens-focal.yml": yaml("[0, 0, 32, 0, 30, 16, 0, 0, 1]"),
        "lens-huge.yml": yaml("[1e300, 0, 32, 0, 30, 16, 0, 0, 1]"),
        "lens-far.yml": yaml("[30, 0, 1e9, 0, 30, 16, 0, 0, 1]"),
        "lens-skewed.yml": yaml("[30, 1, 32, 0, 30, 16, 0, 0, 1]"),
        "lens-matrix.yml": yaml("[30, 0, 32]"),
        "lens-rows.yml": yaml(rows=5),
        "kalibr.yml": KALIBR % "cam0" + KALIBR % "cam1",
        "kalibr-omni.yml": (KALIBR % "cam0").replace("pinhole", "omni"),
        "lens-width.yml": yaml(width="-64"),
        "lens-no-width.yml": yaml(width="[]"),
        "lens-fisheye.yml": yaml(more="fisheye_model: 1\n"),
        "lens-model.yml": yaml(more="distortion_model: omni\n"),
        "lens-cut.yml": yaml()[:90],
        "lens-broken.yml": yaml(matrix="[30, 0"),
        "lens-text.yml": "a lens\n",
        "cameras.txt": COLMAP,
        "cameras-model.txt": "1 MAGIC 64 32 30\n",
        "cameras-few.txt": "1 PINHOLE 64 32 30 30\n",
        "cameras-word.txt": "1 PINHOLE 64 32 30 30 wide 16\n",
    }


# arguments, exit code, what the line must hold
LENSES = [
    ("--lens-file lens.yml", DONE, None),
    ("--lens-file lens-uneven.yml", DONE, None),
    ("--lens-file lens-fisheye.yml", DONE, None),
    ("--lens-file cameras.txt#2", DONE, None),
    ("--lens-file missing.yml", FAILED, "missing.yml"),
    ("--lens-file folder.vtk", FAILED, "folder.vtk"),
    ("--lens-file lens-turns.yml", USAGE, "stops growing"),
    ("--lens-file lens-turns.yml --fov 50", DONE, None),
    ("--lens-file lens-turns-unevenly.yml", USAGE, "stops growing"),
    ("--lens-file lens-turns-unevenly.yml --fov 90", USAGE, "stops growing"),
    ("--lens-file lens-nan.yml", USAGE, "not finite"),
    ("--lens-file lens-word.yml", USAGE, "line 14 has something else where a number belongs"),
    ("--lens-file lens-prism.yml", USAGE, "thin prism"),
    ("--lens-file lens-focal.yml", USAGE, "focal"),
    ("--lens-file lens-huge.yml", USAGE, "1e+300 of 64"),
    ("--lens-file lens-far.yml", USAGE, "principal point"),
    ("--lens-file lens-skewed.yml", USAGE, "camera matrix"),
    ("--lens-file lens-matrix.yml", USAGE, "a matrix of 3 rows and 3 columns has 3 numbers"),
    ("--lens-file lens-rows.yml", USAGE, "a matrix of 5 rows and 1 columns has 4 numbers"),
    ("--lens-file kalibr.yml#cam1", DONE, None),
    ("--lens-file kalibr.yml", USAGE, "has the cameras cam0, cam1; write"),
    ("--lens-file kalibr.yml#cam2", USAGE, "none cam2"),
    ("--lens-file kalibr-omni.yml", USAGE, "its camera_model 'omni'"),
    ("--lens-file lens-width.yml", USAGE, "-64"),
    ("--lens-file lens-no-width.yml", USAGE, "size"),
    ("--lens-file lens-model.yml", USAGE, "omni"),
    ("--lens-file lens-cut.yml", USAGE, "lens-cut.yml"),
    ("--lens-file lens-broken.yml", USAGE, "lens-broken.yml"),
    ("--lens-file lens-text.yml", USAGE, "no calibration"),
    ("--lens-file noise.vtk", USAGE, "not YAML; check"),
    ("--lens-file cameras.txt", USAGE, "1, 2"),
    ("--lens-file cameras.txt#3", USAGE, "none 3"),
    ("--lens-file cameras-model.txt", USAGE, "MAGIC"),
    ("--lens-file cameras-few.txt", USAGE, "PINHOLE"),
    ("--lens-file cameras-word.txt", USAGE, "wide"),
    ("--lens-file lens.yml --lens 1", USAGE, "--lens"),
    ("--lens-file lens.yml --circle 3,4,5", USAGE, "--circle"),
    ("--lens-file lens.yml --projection hammer", USAGE, "hammer"),
    ("--lens-file lens-fisheye.yml --projection brown-conrady", USAGE, "azimuthal-equidistant"),
    ("--circle 3,4,5", USAGE, "round"),
    ("--projection stereographic --circle 3,4", USAGE, "--circle"),
    ("--projection stereographic --circle 3,4,0", USAGE, "radius"),
    ("--projection stereographic --circle 3,4,nan", USAGE, "nan"),
    ("--projection stereographic --circle 1e9,4,20", USAGE, "principal point"),
    ("--projection stereographic --circle 30,4,20 --stereo warped", USAGE, "warped"),
    ("--projection stereographic --circle 30,4,20", DONE, None),
    ("--borders -60,90,-45,45", DONE, None),
    ("--projection perspective --borders 0,40,-5,20", DONE, None),
    ("--borders -60,90,-45", USAGE, "--borders"),
    ("--borders 90,-60,-45,45", USAGE, "left must be below right"),
    ("--borders -200,90,-45,45", USAGE, "must be above 0 and at most 360"),
    ("--borders nan,90,-45,45", USAGE, "nan"),
    ("--borders 10,10.00001,-45,45", USAGE, "so small a part"),
    ("--borders -60,90,-45,45 --hfov 90", USAGE, "--hfov"),
    ("--borders -60,90,-45,45 --technique cubemap", USAGE, "--borders"),
    ("--projection stereographic --borders -60,90,-45,45", USAGE, "--circle"),
    ("--borders -60,90,-45,45 --stereo omnidirectional --layout split", USAGE, "--layout"),
    ("--projection hammer --direction-map cube-3x2", USAGE, "direction-map alone"),
    ("--direction-map cube-cross", DONE, None),
    ("--direction-map foo", USAGE, "there is no file or map 'foo'; give a file, or one of mirror-ball"),
]
