/** A report that a server on this machine keeps up to date. */

interface State {
  revision: string;
  error: string | null;
}

const PAUSE = 1000;

/** Show the document, and again whenever the server has another one or cannot make one. */
export async function follow(show: (text: string, error: string | null) => void): Promise<void> {
  let known: State = { revision: "", error: null };
  let text = "";
  for (;;) {
    const state = await ask();
    if (state.revision && state.revision !== known.revision) text = await (await fetch("/document")).text();
    if (state.revision !== known.revision || state.error !== known.error) {
      known = state;
      if (text) show(text, state.error);
      else if (state.error) throw new Error(state.error);
    }
    await new Promise((resolve) => setTimeout(resolve, PAUSE));
  }
}

async function ask(): Promise<State> {
  try {
    return (await (await fetch("/state")).json()) as State;
  } catch {
    return { revision: "", error: "The server does not answer; start rosarch serve again." };
  }
}
