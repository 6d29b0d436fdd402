/** The launch files of a system: which includes which, and what each starts. */
import { Fragment } from "preact";
import type { LaunchFile, Place, System } from "../data";
import { counted } from "../model";
import { WhyStarted } from "../parts/proof";
import { Source, splitPlace } from "../parts/source";
import { NoSystem, SystemChoice, useSystem } from "../parts/system";
import { Name } from "../parts/text";
import { componentHref, href, type Route } from "../route";

export function LaunchPage({ route }: { route: Route }) {
  const system = useSystem(route);
  if (!system) return <NoSystem title="Launch files" />;
  return (
    <>
      <h1>Launch files</h1>
      <div class="controls">
        <SystemChoice system={system} />
        <span class="muted">{counted(system.nodes.length, "node")}</span>
      </div>
      <ul class="tree">
        {system.files.map((file) => (
          <File key={file.text} file={file} system={system} />
        ))}
      </ul>
    </>
  );
}

function File({ file, system }: { file: LaunchFile; system: System }) {
  const entries = [
    ...file.includes.map((inner) => ({
      line: lineOf(inner.at),
      key: `f${inner.at} ${inner.text}`,
      item: <File file={inner} system={system} />,
    })),
    ...file.nodes.map((node) => ({
      line: lineOf(node.at),
      key: `n${node.at} ${node.name}`,
      item: <Node node={node} system={system} />,
    })),
  ].sort((a, b) => a.line - b.line);
  return (
    <li>
      <details open>
        <summary>
          <Name text={file.file ?? (file.text || "a file whose name is not known")} strong />
          {file.file === null && <span class="tag bad">not there</span>}
          {file.cut && <span class="tag">not told again</span>}
        </summary>
        {file.at && (
          <div class="muted included">
            included at <Source at={file.at} />
          </div>
        )}
        {entries.length > 0 && (
          <ul class="tree">
            {entries.map(({ key, item }) => (
              <Fragment key={key}>{item}</Fragment>
            ))}
          </ul>
        )}
      </details>
    </li>
  );
}

const lineOf = (at: Place | null): number => (at ? splitPlace(at)[1] : 0);

function Node({ node, system }: { node: LaunchFile["nodes"][number]; system: System }) {
  const started = system.nodes.find((each) => each.name === node.name && each.lines.at(-1) === node.at);
  const program = `${node.package}/${node.type}`;
  return (
    <li class="node">
      <a href={href(["graph"], { system: system.name, focus: node.name })}>
        <Name text={node.name} />
      </a>{" "}
      <span class="muted">
        {started?.origin === "source" && started.component ? (
          <a href={componentHref(started.component)}>
            <Name text={program} />
          </a>
        ) : (
          <Name text={program} />
        )}
        {started?.origin === "unknown" && <span class="tag">no model</span>}
        {started?.origin === "library" && <span class="tag">library</span>}
        {node.conditions.length > 0 && <code class="condition"> if {node.conditions.join(" and ")}</code>}
      </span>{" "}
      <Source at={node.at} /> {started && <WhyStarted system={system} node={started} />}
    </li>
  );
}
