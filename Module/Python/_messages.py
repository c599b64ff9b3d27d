# SPDX-License-Identifier: BSD-3-Clause
"""What an object of VTK's says, as text."""

from typing import Any, List

from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject


class Messages:
    """Takes the errors and warnings of an object, which VTK then does not print."""

    def __init__(self, source: vtkObject) -> None:
        self.texts: List[str] = []
        self._source = source
        self._tags: List[int] = []

    def __enter__(self) -> "Messages":
        def take(_source: Any, _event: str, text: str) -> None:
            # "ERROR: In FILE, line N\nCLASS (ADDRESS): TEXT\n\n"
            self.texts.append(text.split("): ", 1)[-1].strip())

        take.CallDataType = VTK_STRING  # type: ignore[attr-defined]
        for event in ("ErrorEvent", "WarningEvent"):
            self._tags.append(self._source.AddObserver(event, take))
        return self

    def __exit__(self, *_error: Any) -> None:
        for tag in self._tags:
            self._source.RemoveObserver(tag)
