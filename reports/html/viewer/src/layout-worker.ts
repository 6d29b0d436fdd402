/** elkjs: in a worker it listens to messages by itself; on a page it is a class that does as if it were one. */
import * as elk from "elkjs/lib/elk-worker.min.js";

const { Worker: InPage } = elk as unknown as { Worker?: unknown };
if (InPage) Object.assign(globalThis, { ElkWorker: InPage });
