/** How often topics of a system are sent on. */
import type { Rate } from "../data";
import { amount } from "../model";
import { Filter, matches, Table } from "../parts/controls";
import { NoSystem, SystemChoice, useSystem } from "../parts/system";
import { Name } from "../parts/text";
import type { Route } from "../route";

export function TimingPage({ route }: { route: Route }) {
  const system = useSystem(route);
  if (!system) return <NoSystem title="Rates and chains" />;
  const filter = route.params.get("filter") ?? "";
  const shown = system.rates.filter((rate) => matches(filter, rate.topic, ...rate.senders));
  return (
    <>
      <h1>Rates and chains</h1>
      <div class="controls">
        <SystemChoice system={system} />
        <Filter label="Filter by topic or sender" param="filter" value={filter} />
      </div>
      <Table label="Rates of topics" head={["Topic", "Messages a second", "Sent by", "Why it is not known"]}>
        {shown.map((rate) => (
          <tr key={rate.topic}>
            <td>
              <Name text={rate.topic} strong />
            </td>
            <td class="number">{rateText(rate)}</td>
            <td>
              <Name text={rate.senders.join(", ")} />
            </td>
            <td class="muted">{rate.reasons.join("; ")}</td>
          </tr>
        ))}
      </Table>
    </>
  );
}

export function rateText(rate: Rate): string {
  if (rate.high === null) return rate.low ? `${amount(rate.low)} or more` : "not known";
  return rate.low === rate.high ? amount(rate.low) : `${amount(rate.low)} to ${amount(rate.high)}`;
}
