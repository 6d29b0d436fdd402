import { render } from "preact";
import { App } from "./app";
import { type ReportDocument, unpack } from "./data";
import { indexed } from "./model";

async function start() {
  const place = document.getElementById("app");
  if (!place) return;
  const report = JSON.parse(await unpack("document")) as ReportDocument;
  place.replaceChildren();
  render(<App report={indexed(report)} />, place);
}

start().catch((error: unknown) => {
  const place = document.getElementById("app");
  if (place) place.textContent = `This report cannot be shown: ${error instanceof Error ? error.message : error}`;
});
