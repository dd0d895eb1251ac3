// A worker: one module that answers one question at a time.

import { Door } from "./door";
import type { Answer, Ask, Broken, Start } from "./messages";

const scope = self as unknown as {
  onmessage: ((event: MessageEvent<Start | Ask>) => void) | null;
  postMessage(message: Answer | Broken, transfer?: Transferable[]): void;
};

let door: Promise<Door> | undefined;

scope.onmessage = async ({ data }) => {
  if ("module" in data) {
    door = Door.open(data.module);
    return;
  }
  try {
    const module = await door;
    if (!module) throw new Error("no module");
    if (data.files) module.ask("PUT /shelf", JSON.stringify(data.files));
    const answer = module.ask(data.head, data.body);
    scope.postMessage(answer, [answer.bytes]);
  } catch (error) {
    // A mistake of the module ends it: its memory cannot be trusted any more.
    scope.postMessage({ broken: String(error) });
  }
};
