# browser.py - a page in headless Chromium, told what to do through a pair of pipes
# SPDX-License-Identifier: Apache-2.0
"""Writes a screenshot, and what the page complained of on stderr, with exit code 1. --there: exit
code 0 if there is a Chromium. Messages of the DevTools protocol go to its fd 3 and come from fd 4,
each ended by a 0."""
import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SECONDS = 60  # for an answer, on a busy machine


class Browser:
    """`with Browser() as b: b.open(PATH)`; complaints: errors and warnings of the page's console,
    and addresses that it asked for beside its own."""

    def __init__(self, width=1000, height=800, dark=False):
        self.complaints, self.number, self.buffer, self.seen = [], 0, b"", []
        self.folder = tempfile.mkdtemp(prefix="browser.")
        theirs_in, self.to = os.pipe()
        self.of, theirs_out = os.pipe()
        high = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (theirs_in, theirs_out)]

        def pipes():  # in the child
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)
        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
             "--disable-dev-shm-usage", "--remote-debugging-pipe", "--hide-scrollbars",
             "--force-color-profile=srgb", f"--user-data-dir={self.folder}", "about:blank"],
            preexec_fn=pipes, close_fds=False, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for fd in (theirs_in, theirs_out, *high):
            os.close(fd)
        page = next(t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=page["targetId"],
                                flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")
        self.size = width, height
        self.ask("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    session = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        os.close(self.to)
        os.close(self.of)
        shutil.rmtree(self.folder, ignore_errors=True)

    def message(self):
        """The next one that Chromium sends."""
        end = time.monotonic() + SECONDS
        while b"\0" not in self.buffer:
            if not select.select([self.of], [], [], max(end - time.monotonic(), 0))[0]:
                sys.exit("browser: Chromium does not answer")
            more = os.read(self.of, 1 << 20)
            if not more:
                sys.exit("browser: Chromium ended")
            self.buffer += more
        text, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(text)

    def take(self, message):
        """Notes an event."""
        name, told = message.get("method"), message.get("params", {})
        self.seen.append(name)
        if name == "Runtime.exceptionThrown":
            details = told["exceptionDetails"]
            self.complaints.append(details.get("exception", details).get("description",
                                                                         details["text"]))
        elif name == "Runtime.consoleAPICalled" and told["type"] in ("error", "warning"):
            self.complaints.append(str([a.get("value") for a in told["args"]]))
        elif name == "Log.entryAdded" and told["entry"]["level"] in ("error", "warning"):
            self.complaints.append(told["entry"]["text"])
        elif name == "Network.requestWillBeSent":
            address = told["request"]["url"]
            if not address.startswith("data:") and address != self.address:
                self.complaints.append("asks for " + address)

    address = None

    def ask(self, method, **params):
        """The result of a method; events on the way are noted."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.number:
                if "error" in answer:
                    sys.exit(f"browser: {method}: {answer['error']['message']}")
                return answer["result"]
            self.take(answer)

    def resize(self, width, height):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height,
                 deviceScaleFactor=1, mobile=False)

    def value(self, expression):
        """What a script on the page evaluates to."""
        found = self.ask("Runtime.evaluate", expression=expression, returnByValue=True,
                         awaitPromise=True)
        return found["result"].get("value")

    def open(self, path):
        """Goes to a file and waits until it is loaded and its maps are painted."""
        self.address, self.seen = Path(path).resolve().as_uri(), []
        self.resize(*self.size)
        self.ask("Page.navigate", url=self.address)
        while "Page.loadEventFired" not in self.seen:
            self.take(self.message())
        self.until("!document.getElementById('planes') || document.body.dataset.painted")

    def until(self, expression):
        end = time.monotonic() + SECONDS
        while not self.value(expression):
            if self.complaints or time.monotonic() > end:
                return
            time.sleep(.1)

    def mouse(self, kind, x, y, buttons=0):
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, buttons=buttons, clickCount=1,
                 button="left" if buttons or kind == "mouseReleased" else "none")

    def screenshot(self, path, whole=False):
        data = self.ask("Page.captureScreenshot", captureBeyondViewport=whole)["data"]
        Path(path).write_bytes(base64.b64decode(data))


def main(page=None, picture=None, width="1000", height="800", colours="light", there=False):
    if there or picture is None:
        sys.exit(not (there and shutil.which("chromium")))
    with Browser(int(width), int(height), colours == "dark") as browser:
        browser.open(page)
        browser.screenshot(picture)
        print(*browser.complaints, sep="\n", file=sys.stderr)
        sys.exit(bool(browser.complaints))
