"""A headless Chromium driven through its own protocol over a pipe: no network port, no further package."""

import base64
import itertools
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--remote-debugging-pipe",
)


def executable():
    """Path of the browser, or None."""
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Chromium:
    """A page of one browser. `messages` collects errors and warnings of console and network."""

    def __init__(self, timeout=60):
        self.timeout = timeout
        self.messages = []
        self._numbers = itertools.count(1)
        self._buffer = b""
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._start()
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._browser.kill()
        self._browser.wait()
        os.close(self._write)
        os.close(self._read)
        self._profile.cleanup()

    def _start(self):
        """The browser reads commands from descriptor 3 and writes answers to 4."""
        self._session = None
        command_read, self._write = os.pipe()
        self._read, answer_write = os.pipe()
        shell = f'exec "$0" "$@" 3<&{command_read} 4>&{answer_write}'
        flags = [*FLAGS, f"--user-data-dir={self._profile.name}", "about:blank"]
        self._browser = subprocess.Popen(
            ["/bin/bash", "-c", shell, executable(), *flags],
            pass_fds=(command_read, answer_write),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(command_read)
        os.close(answer_write)

    def call(self, method, **parameters):
        """Sends one command and returns its result."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._receive()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def _receive(self):
        deadline = time.monotonic() + self.timeout
        while b"\0" not in self._buffer:
            if not select.select([self._read], [], [], max(0, deadline - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            part = os.read(self._read, 1 << 20)
            if not part:
                raise RuntimeError("the browser ended")
            self._buffer += part
        text, self._buffer = self._buffer.split(b"\0", 1)
        answer = json.loads(text)
        self._note(answer.get("method"), answer.get("params", {}))
        return answer

    def _note(self, method, parameters):
        if method == "Runtime.exceptionThrown":
            self.messages.append(str(parameters["exceptionDetails"]))
        elif method == "Log.entryAdded" and parameters["entry"]["level"] in ("warning", "error"):
            self.messages.append(parameters["entry"]["text"])
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("warning", "error"):
            self.messages.append(str(parameters["args"]))
        elif method == "Network.requestWillBeSent" and not parameters["request"]["url"].startswith(
            ("file:", "data:", "about:")
        ):
            self.messages.append(f"the page asked the network for {parameters['request']['url']}")

    def open(self, path, width, height, scheme="light", hash=""):
        """Loads a file at the given viewport with the preferred colour scheme 'light' or 'dark'."""
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=width < 600,
        )
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.call("Page.navigate", url="about:blank")  # so that a page is loaded anew when only the part after # differs
        self.call("Page.navigate", url=pathlib.Path(path).resolve().as_uri() + hash)
        self._wait_for_file()

    def follow(self, expression):
        """Evaluates what leads to another file, and waits for it."""
        self.leave()
        self.evaluate(f"{expression}; 0")
        self.arrive()

    def leave(self):
        """Marks the page that is open, for `arrive` to know another."""
        self.evaluate("globalThis.left = true; 0")

    def arrive(self):
        """Waits until another file than the marked one is loaded."""
        deadline = time.monotonic() + 10
        while time.monotonic() < deadline:
            try:
                if self.evaluate("globalThis.left") is None:
                    break
            except RuntimeError:  # between two files
                pass
            time.sleep(0.02)
        self._wait_for_file()

    def _wait_for_file(self):
        deadline = time.monotonic() + self.timeout
        while not self._is_loaded():
            if time.monotonic() > deadline:
                raise TimeoutError("the page does not finish loading")

    def _is_loaded(self):
        try:
            return self.evaluate("document.readyState + location.protocol") == "completefile:"
        except RuntimeError:  # one page leads to another
            return False

    def is_there(self, name):
        """Whether the page, once it is loaded, has a part of this identifier."""
        return self._is_loaded() and self.evaluate(f"Boolean(document.getElementById({json.dumps(name)}))")

    def allow_scripts(self, allowed):
        """Whether scripts of pages opened from now on run; evaluate() works either way."""
        self.call("Emulation.setScriptExecutionDisabled", value=not allowed)

    def mouse(self, kind, x, y, **more):
        """'mouseMoved', 'mousePressed', 'mouseReleased' or 'mouseWheel' at a place of the viewport."""
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def press(self, key, code=0, text=""):
        """A key down and up, by its DOM name."""
        more = {"windowsVirtualKeyCode": code, "text": text} if text else {"windowsVirtualKeyCode": code}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, **more)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)

    def evaluate(self, expression):
        """Value of a JavaScript expression in the page; a promise is waited for."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(str(answer["exceptionDetails"]))
        return answer["result"].get("value")

    def screenshot(self, path):
        """The viewport as PNG."""
        data = self.call("Page.captureScreenshot", format="png")["data"]
        pathlib.Path(path).write_bytes(base64.b64decode(data))

    def pdf(self, **options):
        """The page as printed."""
        return base64.b64decode(self.call("Page.printToPDF", **options)["data"])
