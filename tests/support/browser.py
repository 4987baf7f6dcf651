"""A headless Chromium, and what it says of the pages in a folder."""

import json
import shutil
import subprocess
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import quote

from hangs import HANGS

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
FLAGS = (
    "--headless --no-sandbox --disable-quic --no-first-run --disable-background-networking --disable-component-update "
    "--disable-sync"
)
ASK = """<body><script>
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
async function opened(page) {
  const frame = document.createElement("iframe"), errors = [];
  frame.style = "height: 900px; border: 0";
  document.body.append(frame);
  await new Promise((done) => { frame.onload = done; frame.src = page; });
  frame.contentWindow.onerror = (text) => errors.push(text);
  const inside = frame.contentDocument, root = inside.documentElement;
  for (const image of inside.images) { image.loading = "eager"; await image.decode().catch(() => {}); }
  for (let i = 0; page.includes("?q=") && i < 200 && !inside.querySelector(".search li"); i++) await pause(50);
  const missing = [...inside.images].filter((i) => !i.naturalWidth).map((i) => i.src);
  const found = [...inside.querySelectorAll(".search li a")].map((a) => a.textContent);
  const said = WIDTHS.map((width) => {
    frame.style.width = `${width}px`;
    return {page, width, over: root.scrollWidth - root.clientWidth, errors, title: inside.title, missing, found};
  });
  frame.remove();
  return said;
}
(async () => {
  const said = [];
  for (const page of PAGES) said.push(...await opened(page));
  await fetch("/said", {method: "POST", body: JSON.stringify(said)});
})();
</script></body>"""


class _Asking(SimpleHTTPRequestHandler):
    """Gives the pages of a folder and the one that opens them all; takes what it says."""

    def log_message(self, *arguments):
        pass

    def do_GET(self):
        if self.path == "/ask":
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(self.server.ask.encode())
        else:
            super().do_GET()

    def do_POST(self):
        self.server.said = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()
        self.server.heard.set()


def opened(folder, pages, widths, profile):
    """What Chromium says of each page at each width, in pixels.

    Returns:
        dictionaries of page, width, title; over, pixels that it is too wide; missing pictures; errors of scripts; what a
        search has found, the first first.
    """
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(_Asking, directory=str(folder))) as server:
        server.heard, server.said = threading.Event(), None
        asked = ASK.replace("PAGES", json.dumps([quote(page, safe="/?=+") for page in pages]))
        server.ask = asked.replace("WIDTHS", json.dumps(widths))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}/ask"
        command = [
            CHROMIUM,
            *FLAGS.split(),
            "--disable-gpu",
            f"--user-data-dir={profile}",
            "--window-size=1600,1000",
            "--remote-debugging-port=0",
        ]
        browser = subprocess.Popen([*command, address], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            server.heard.wait(HANGS)
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
        return server.said
