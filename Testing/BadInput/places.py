# SPDX-License-Identifier: BSD-3-Clause
"""Ways to hamper a process: where it may write, and how much."""

import os
import resource
import subprocess

OLD = b"an earlier picture, which a failure must not touch\n"

# Bytes a file may grow to in "file size limit": less than any picture.
FILE_SIZE_LIMIT = 512

READ_ONLY = 'mount --bind "$OUT" "$OUT" && mount -o remount,bind,ro "$OUT" || exit 99; exec "$@"'

# One page, which the earlier picture fills. The folder vanishes with the process, so
# what is left in it is copied out.
FULL_DISK = (
    'mount -t tmpfs -o size=4k tmpfs "$OUT" && cp "$KEPT/old.png" "$OUT" || exit 99; "$@"; '
    'code=$?; rm -r "$KEPT" && cp -a "$OUT" "$KEPT"; exit $code'
)


def find_namespace():
    """The command that gives a process mounts of its own, or None where that is barred."""
    for command in (["unshare", "--mount"], ["unshare", "--user", "--map-root-user", "--mount"]):
        probe = command + ["sh", "-c", "mount -t tmpfs -o size=4k tmpfs /mnt"]
        try:
            if subprocess.run(probe, capture_output=True, check=False).returncode == 0:
                return command
        except FileNotFoundError:
            return None
    return None


def limit_file_size():
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_SIZE_LIMIT, FILE_SIZE_LIMIT))


class Place:
    """A folder for outputs that holds old.png, hampered as `kind` says.

    wrap(command) gives the command to run, options the keywords for subprocess, folder
    where to look afterwards. possible is False where this machine cannot do it.
    """

    NAMESPACE = find_namespace()
    KINDS = (
        "plain",
        "folder in the way",
        "read-only",
        "full disk",
        "file size limit",
        "full standard output",
    )

    def __init__(self, kind, parent):
        if kind not in self.KINDS:
            raise ValueError("no such place: " + kind)
        self.kind = kind
        self.out = os.path.join(parent, "out")
        self.kept = os.path.join(parent, "kept")
        for folder in (self.out, self.kept):
            os.mkdir(folder)
            with open(os.path.join(folder, "old.png"), "wb") as stream:
                stream.write(OLD)
        if kind == "folder in the way":
            os.mkdir(os.path.join(self.out, "folder.png"))
        self.before = sorted(os.listdir(self.out))

    @property
    def possible(self):
        return self.kind not in ("read-only", "full disk") or self.NAMESPACE is not None

    @property
    def folder(self):
        return self.kept if self.kind == "full disk" else self.out

    def wrap(self, command):
        script = {"read-only": READ_ONLY, "full disk": FULL_DISK}.get(self.kind)
        return self.NAMESPACE + ["sh", "-c", script, "sh"] + command if script else command

    def environment(self):
        return {"OUT": self.out, "KEPT": self.kept}

    def options(self):
        if self.kind == "file size limit":
            # Python ignores SIGXFSZ; so must the child, to see the error instead
            return {"preexec_fn": limit_file_size, "restore_signals": False}
        if self.kind == "full standard output":
            return {"stdout": open("/dev/full", "wb")}
        return {}
