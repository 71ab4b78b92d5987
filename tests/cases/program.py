# SPDX-License-Identifier: LGPL-2.1-or-later
"""Call the program many times: by the fork server beside it (see
tests/fork_server.cc), which saves half a second a call, else as a process.

Not for calls that are killed, that run beside others or under mpirun: those
are of the program itself.
"""

import atexit
import functools
import os
import struct
import subprocess
import sys
import tempfile

# A child of the server has these of the server.
THREADS = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
# MPI looks for no other processes: a run starts in half the time.
ALONE = {"OMPI_MCA_ess_singleton_isolated": "1"}
SERVER = "fork_server"


class Program:
    """`run` is like subprocess.run, with captured output. To be closed, or used
    in a `with`. `direct`: without the server."""

    def __init__(self, path, direct=False):
        self.path = os.path.abspath(path)
        self.environment = dict(os.environ, **THREADS, **ALONE)
        self._server = None
        self._place = None
        server = os.path.join(os.path.dirname(self.path), SERVER)
        if direct:
            return
        # One of an older build would test other code than it seems to.
        if (not os.path.exists(server) or
                os.path.getmtime(server) < os.path.getmtime(self.path)):
            print(f"no {SERVER} of this build: slower without", flush=True)
            return
        self._place = tempfile.TemporaryDirectory(prefix="waker-calls-")
        self._server = subprocess.Popen(
            [server], env=self.environment, bufsize=0,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self._server is not None:
            self._server.stdin.close()
            self._server.wait()
            self._server.stdout.close()
            self._place.cleanup()
            self._server = None

    def run(self, arguments, cwd=None, stdin=b"", env=None, check=False):
        """Arguments are texts or bytes, `stdin` is what can be read there, `env`
        the whole environment. The output is text, with "\\udcNN" for bytes that
        are none. `check`: the test ends unless the exit code is 0."""
        words = [self.path, *arguments]
        env = self.environment if env is None else env
        stdin = os.fsencode(stdin)
        if self._server is None:
            done = subprocess.run(words, cwd=cwd, input=stdin, env=env,
                                  capture_output=True, check=False)
            code, out, err = done.returncode, done.stdout, done.stderr
        else:
            code, out, err = self._ask(words, cwd, stdin, env)
        done = subprocess.CompletedProcess(words, code, text(out), text(err))
        if check and code != 0:
            sys.exit(f"{' '.join(map(str, words))}\nended with {code}:\n"
                     f"{done.stdout}{done.stderr}")
        return done

    def _ask(self, words, cwd, stdin, env):
        paths = [os.path.join(self._place.name, name)
                 for name in ("stdin", "stdout", "stderr")]
        for path, data in zip(paths, (stdin, b"", b"")):
            with open(path, "wb") as file:
                file.write(data)
        strings = [os.path.abspath(cwd or "."), *paths,
                   *(f"{name}={value}" for name, value in env.items()), "",
                   *words]
        strings = [os.fsencode(string) for string in strings]
        if any(b"\0" in string for string in strings):
            raise ValueError("a zero in an argument")
        request = b"".join(string + b"\0" for string in strings)
        self._write(struct.pack("=I", len(request)) + request)
        answer = self._server.stdout.readline()
        if not answer:
            sys.exit(f"{SERVER} ended with {self._server.wait()}")
        contents = []
        for path in paths[1:]:
            with open(path, "rb") as file:
                contents.append(file.read())
        if int(answer) == 99:
            sys.exit(os.fsdecode(contents[1]))
        return int(answer), *contents

    def _write(self, data):
        # Without a buffer, a long request goes in pieces.
        view = memoryview(data)
        while view:
            view = view[self._server.stdin.write(view):]


@functools.lru_cache(maxsize=None)
def shared(path):
    """One Program for all that call it, to the end of the test."""
    program = Program(path)
    atexit.register(program.close)
    return program


def text(data):
    return data.decode("utf-8", "surrogateescape")
