// Workers that answer, one question at a time each: as many as the machine has room for.

import type { Answer, Ask, Broken, Start } from "./messages";

/** What the pool needs of a worker. */
export interface Hand {
  postMessage(message: Start | Ask): void;
  onmessage: ((event: MessageEvent<Answer | Broken>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

interface Job {
  head: string;
  body: string;
  lane: string | undefined;
  done: (answer: Answer) => void;
  failed: (reason: unknown) => void;
}

interface Member {
  hand: Hand;
  job: Job | undefined;
  /** Which files it has. */
  files: number;
}

const encode = (value: unknown) => new TextEncoder().encode(JSON.stringify(value)).buffer;
const refusal = (status: number, message: string, hint: string): Answer => ({
  status,
  kind: "application/json",
  bytes: encode({ message, hint, diagnostics: [], found: null }),
});

/** What a question gets that a newer one replaced. */
const superseded = () =>
  refusal(409, "a newer question took the place of this one", "wait for the newer answer");
/** What a question gets whose computation broke off. */
const broken = () =>
  refusal(
    500,
    "the computation broke off",
    "this is an internal error: please report it with the engine file",
  );

export class Pool {
  #members: Member[] = [];
  #waiting: Job[] = [];
  #files: Record<string, string> = {};
  /** Counts the changes of the files. */
  #edition = 0;

  constructor(
    private readonly module: WebAssembly.Module,
    private readonly hire: () => Hand,
    private readonly most: number,
  ) {}

  /** The files that questions asked from now on see. */
  set files(files: Record<string, string>) {
    this.#files = files;
    this.#edition += 1;
  }

  /**
   * The answer. An older question of the same lane is answered with "superseded"; one that `signal` breaks off fails with its reason. What is
   * being computed for either ends with its worker: there is no other way to reach one that computes.
   */
  ask(head: string, body: string, lane?: string, signal?: AbortSignal): Promise<Answer> {
    return new Promise((done, failed) => {
      if (signal?.aborted) return failed(signal.reason);
      if (lane !== undefined) this.#supersede(lane);
      const job: Job = { head, body, lane, done, failed };
      signal?.addEventListener("abort", () => this.#drop(job) && failed(signal.reason), { once: true });
      this.#waiting.push(job);
      this.#next();
    });
  }

  #supersede(lane: string) {
    const jobs = [...this.#waiting, ...this.#members.map((member) => member.job)];
    for (const job of jobs) if (job?.lane === lane && this.#drop(job)) job.done(superseded());
  }

  /** Takes a question out; `false` where it was answered already. */
  #drop(job: Job): boolean {
    if (this.#waiting.includes(job)) {
      this.#waiting = this.#waiting.filter((other) => other !== job);
      return true;
    }
    const member = this.#members.find((member) => member.job === job);
    if (!member) return false;
    this.#dismiss(member);
    this.#next();
    return true;
  }

  #dismiss(member: Member) {
    member.hand.terminate();
    this.#members = this.#members.filter((other) => other !== member);
  }

  #next() {
    while (this.#waiting.length > 0) {
      const member = this.#members.find((member) => member.job === undefined) ?? this.#hire();
      if (!member) return;
      const job = this.#waiting.shift();
      if (!job) return;
      member.job = job;
      const files = member.files === this.#edition ? null : this.#files;
      member.files = this.#edition;
      member.hand.postMessage({ head: job.head, body: job.body, files });
    }
  }

  #hire(): Member | undefined {
    if (this.#members.length >= this.most) return undefined;
    const member: Member = { hand: this.hire(), job: undefined, files: -1 };
    const end = (answer: Answer) => {
      const job = member.job;
      member.job = undefined;
      job?.done(answer);
      this.#next();
    };
    member.hand.onmessage = ({ data }) => {
      if ("broken" in data) {
        console.error(`the studio's module broke off: ${data.broken}`);
        this.#dismiss(member);
        end(broken());
      } else end(data);
    };
    member.hand.onerror = (event) => {
      console.error(`a worker of the studio broke off: ${event.message}`);
      this.#dismiss(member);
      end(broken());
    };
    member.hand.postMessage({ module: this.module });
    this.#members.push(member);
    return member;
  }
}
