# SPDX-License-Identifier: BSD-3-Clause
"""Runs functions in processes of their own, which may crash."""

import json
import os
import select
import signal
import time


def run(function, name, seconds=120):
    """What function(name) returns, from a copy of this process; {"crash": how} where that ended
    otherwise."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        answer(function, name, writer)
    os.close(writer)
    text = receive(reader, time.monotonic() + seconds)
    if text is None:
        os.kill(child, signal.SIGKILL)
    status = os.waitpid(child, 0)[1]
    if text is None:
        return {"crash": "no answer in %g s" % seconds}
    if os.WIFSIGNALED(status):
        return {"crash": signal.Signals(os.WTERMSIG(status)).name}
    if not text:
        return {"crash": "exit code %d" % os.WEXITSTATUS(status)}
    return json.loads(text)


def judge_all(names, judge):
    """judge(name) is what is wrong, a list of texts, each asked in a process of its own; prints it, and
    returns the exit code."""
    wrong = 0
    for name in names:
        faults = run(judge, name)
        faults = [faults["crash"]] if isinstance(faults, dict) else faults
        wrong += bool(faults)
        print("%-45s %s" % (name, "; ".join(faults) or "as it should be"), flush=True)
    print("%d are wrong" % wrong)
    return 1 if wrong else 0


def answer(function, name, writer):
    code = 1
    try:
        result = json.dumps(function(name)).encode()
        with os.fdopen(writer, "wb") as pipe:
            pipe.write(result)
        code = 0
    except Exception as error:  # of whatever kind: the parent reports it
        os.write(writer, json.dumps({"crash": repr(error)}).encode())
    finally:
        os._exit(code)


def receive(reader, deadline):
    """Everything up to the end of the pipe; None where that does not come in time."""
    parts = []
    while True:
        left = deadline - time.monotonic()
        if left <= 0 or not select.select([reader], [], [], left)[0]:
            os.close(reader)
            return None
        part = os.read(reader, 65536)
        if not part:
            os.close(reader)
            return b"".join(parts)
        parts.append(part)
