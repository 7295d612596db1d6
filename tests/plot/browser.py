# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A browser without a window: Debian's chromium, driven by the DevTools
protocol through a pair of pipes. It needs nothing besides Python."""

import base64
import fcntl
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
         "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync",
         "--disable-dev-shm-usage", "--remote-debugging-pipe"]
# Ends a browser that hangs; an answer takes a second.
LONGEST_SILENCE = 240.


class BrowserFailed(Exception):
    """The browser does not start, or says that a command failed."""


def find_browser():
    """The path of a browser, or None."""
    return next(filter(None, map(shutil.which, PROGRAMS)), None)


class Browser:
    """One page of a browser with a fresh profile."""

    def __init__(self, program):
        self.home = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.number, self.session, self.events = 0, None, []
        self.buffer = b""
        self._start(program)
        target = self.call("Target.createTarget", url="about:blank")
        self.session = self.call(
            "Target.attachToTarget", targetId=target["targetId"],
            flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def _start(self, program):
        """The browser reads commands from descriptor 3 and answers on 4."""
        ends = [*os.pipe(), *os.pipe()]
        # Above 4, so that the shell overwrites none of them.
        read, self.output, self.input, write = (
            fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in ends)
        for end in ends:
            os.close(end)
        self.errors = open(os.path.join(self.home.name, "errors.txt"), "wb")
        self.process = subprocess.Popen(
            ["bash", "-c", f'exec "$0" "$@" 3<&{read} 4>&{write} {read}<&- '
             f"{write}>&-", program, *FLAGS,
             f"--user-data-dir={os.path.join(self.home.name, 'profile')}"],
            stdin=subprocess.DEVNULL, stdout=self.errors, stderr=self.errors,
            pass_fds=(read, write), start_new_session=True)
        os.close(read)
        os.close(write)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        os.close(self.output)
        os.close(self.input)
        self.errors.close()
        self.home.cleanup()

    def call(self, method, **parameters):
        """Sends a command and returns its result."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        self._send(json.dumps(message).encode() + b"\0")
        number = self.number
        while True:
            answer = self._receive()
            if answer.get("id") != number:
                self.events.append(answer)
            elif "error" in answer:
                raise BrowserFailed(f"{method}: {answer['error']}")
            else:
                return answer["result"]

    def wait_for(self, method):
        """Waits for an event, which may have come already."""
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self._receive())

    def _send(self, data):
        try:
            while data:
                data = data[os.write(self.output, data):]
        except BrokenPipeError:
            raise BrowserFailed(self._last_words()) from None

    def _receive(self):
        while b"\0" not in self.buffer:
            if not select.select([self.input], [], [], LONGEST_SILENCE)[0]:
                raise BrowserFailed("the browser does not answer")
            block = os.read(self.input, 1 << 20)
            if not block:
                raise BrowserFailed(self._last_words())
            self.buffer += block
        message, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(message)

    def _last_words(self):
        with open(self.errors.name, encoding="utf-8",
                  errors="replace") as file:
            return "the browser ended: " + file.read()[-2000:]

    def open(self, path, width, height=900):
        """Shows a file in a window of that size; returns what was complained
        of on the console, and what was asked for besides the file."""
        self.resize(width, height)
        self.events.clear()
        address = "file://" + os.path.abspath(path)
        self.call("Page.navigate", url=address)
        self.wait_for("Page.loadEventFired")
        # The page's last messages come before this answer.
        self.evaluate("document.fonts.ready.then(() => new Promise("
                      "done => requestAnimationFrame(() => done(0))))")
        return _complaints(self.events), _requests(self.events, address)

    def resize(self, width, height=900):
        self.call("Emulation.setDeviceMetricsOverride", width=width,
                  height=height, deviceScaleFactor=1, mobile=False)

    def evaluate(self, script):
        """The value of an expression on the page, promises awaited."""
        result = self.call("Runtime.evaluate", expression=script,
                           returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise BrowserFailed(str(result["exceptionDetails"]))
        return result["result"].get("value")

    def print_to(self, path):
        """The page on A4 paper, as a PDF."""
        # The default margins of the browser's own dialogue, 1 cm.
        content = self.call("Page.printToPDF", paperWidth=8.27,
                            paperHeight=11.69, printBackground=True)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(content))


def _complaints(events):
    """Errors and warnings on the console."""
    found = []
    for event in events:
        told = event.get("params", {})
        if event.get("method") == "Runtime.exceptionThrown":
            found.append(str(told["exceptionDetails"].get("text")))
        elif event.get("method") == "Log.entryAdded" \
                and told["entry"]["level"] in ("error", "warning"):
            found.append(told["entry"]["text"])
        elif event.get("method") == "Runtime.consoleAPICalled" \
                and told["type"] in ("error", "warning", "assert"):
            found.append(" ".join(str(part.get("value"))
                                  for part in told["args"]))
    return found


def _requests(events, address):
    """Addresses that were asked for, but the page's own and data in it."""
    wanted = [event["params"]["request"]["url"] for event in events
              if event.get("method") == "Network.requestWillBeSent"]
    return [url for url in wanted
            if url.split("#")[0] != address and not url.startswith("data:")]
