import { render } from "preact";
import { App } from "./app";
import { type ReportDocument, unpack } from "./data";
import { follow } from "./live";
import { indexed } from "./model";

async function start() {
  const place = document.getElementById("app");
  if (!place) return;
  const show = (text: string, error: string | null) => {
    place.querySelector(".loading")?.remove();
    render(<App report={indexed(JSON.parse(text) as ReportDocument)} error={error} />, place);
  };
  const text = await unpack("document");
  if (text) show(text, null);
  else await follow(show);
}

start().catch((error: unknown) => {
  const place = document.getElementById("app");
  if (place) place.textContent = `This report cannot be shown: ${error instanceof Error ? error.message : error}`;
});
