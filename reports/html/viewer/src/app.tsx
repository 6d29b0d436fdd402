import { useEffect, useMemo, useState } from "preact/hooks";
import { SharedContext, type Subject } from "./context";
import type { Place } from "./data";
import type { Report } from "./model";
import { ComponentPage } from "./pages/component";
import { ComponentsPage } from "./pages/components";
import { FindingsPage } from "./pages/findings";
import { GraphPage } from "./pages/graph";
import { LaunchPage } from "./pages/launch";
import { OverviewPage } from "./pages/overview";
import { TimingPage } from "./pages/timing";
import { ProofDialog } from "./parts/proof";
import { SourceDialog } from "./parts/source";
import { shortened } from "./parts/text";
import { href, type Route, useRoute } from "./route";
import { useTheme } from "./theme";

const PAGES = [
  ["", "Overview"],
  ["graph", "Graph"],
  ["components", "Components"],
  ["findings", "Findings"],
  ["launch", "Launch files"],
  ["timing", "Rates and chains"],
] as const;

export function App({ report, error }: { report: Report; error: string | null }) {
  const route = useRoute();
  const [place, showSource] = useState<Place | null>(null);
  const [proof, showProof] = useState<Subject | null>(null);
  const shared = useMemo(() => ({ report, showSource, showProof }), [report]);
  const at = route.path[0] === "component" ? "components" : (route.path[0] ?? "");
  useEffect(() => {
    const page = PAGES.find(([name]) => name === at)?.[1] ?? "";
    document.title = `${route.path.slice(1).join("/") || page} – ${report.document.title}`;
  }, [route, report, at]);
  useEffect(openForPrint, []);
  useEffect(searchByKey, []);
  return (
    <SharedContext.Provider value={shared}>
      <a class="skip" href="#main" onClick={skip}>
        Skip to content
      </a>
      <Header at={at} report={report} />
      {error && (
        <p class="alert" role="alert">
          Not up to date: {error}
        </p>
      )}
      <main id="main" tabIndex={-1} class={at === "graph" ? "wide" : ""} key={route.path.join("/")}>
        <Page route={route} />
      </main>
      <SourceDialog at={place} onClose={() => showSource(null)} />
      <ProofDialog subject={proof} onClose={() => showProof(null)} />
    </SharedContext.Provider>
  );
}

function Page({ route }: { route: Route }) {
  switch (route.path[0] ?? "") {
    case "":
      return <OverviewPage />;
    case "graph":
      return <GraphPage route={route} />;
    case "components":
      return <ComponentsPage route={route} />;
    case "component":
      return <ComponentPage name={route.path.slice(1).join("/")} />;
    case "findings":
      return <FindingsPage route={route} />;
    case "launch":
      return <LaunchPage route={route} />;
    case "timing":
      return <TimingPage route={route} />;
    default:
      return (
        <>
          <h1>No such page</h1>
          <p>
            <a href={href([])}>To the overview</a>
          </p>
        </>
      );
  }
}

function Header({ at, report }: { at: string; report: Report }) {
  const [theme, nextTheme] = useTheme();
  return (
    <header class="top">
      <a class="title" href={href([])} title={report.document.title}>
        {shortened(report.document.title, 32)}
      </a>
      <nav aria-label="Pages">
        {PAGES.map(([name, label]) => (
          <a key={name} href={href(name ? [name] : [])} aria-current={at === name ? "page" : undefined}>
            {label}
          </a>
        ))}
      </nav>
      <button type="button" class="quiet theme" onClick={nextTheme} title="Light, dark, or as the system has it">
        {theme === "auto" ? "◐ Auto" : theme === "light" ? "○ Light" : "● Dark"}
      </button>
    </header>
  );
}

function skip(event: MouseEvent) {
  event.preventDefault();
  document.getElementById("main")?.focus();
}

/** `/` leads to the filter of the page. */
function searchByKey() {
  const search = (event: KeyboardEvent) => {
    const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    const filter = document.querySelector<HTMLInputElement>("main .filter");
    if (event.key !== "/" || typing || !filter) return;
    event.preventDefault();
    filter.focus();
  };
  addEventListener("keydown", search);
  return () => removeEventListener("keydown", search);
}

/** What is folded on the page is unfolded on paper, proofs excepted. */
function openForPrint() {
  const opened: HTMLDetailsElement[] = [];
  const before = () => {
    for (const details of document.querySelectorAll<HTMLDetailsElement>("main details:not([open], .proof)")) {
      details.open = true;
      opened.push(details);
    }
  };
  const after = () => {
    for (const details of opened.splice(0)) details.open = false;
  };
  addEventListener("beforeprint", before);
  addEventListener("afterprint", after);
  return () => {
    removeEventListener("beforeprint", before);
    removeEventListener("afterprint", after);
  };
}
