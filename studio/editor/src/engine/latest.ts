// SPDX-License-Identifier: Apache-2.0

/** One piece of work at a time, and then the newest of those that came meanwhile. */
export class Latest<Work> {
  private readonly start: (work: Work) => Promise<void>;
  private waiting: { work: Work } | null = null;
  private isBusy = false;

  constructor(start: (work: Work) => Promise<void>) {
    this.start = start;
  }

  put(work: Work): void {
    this.waiting = { work };
    if (!this.isBusy) void this.go();
  }

  private async go(): Promise<void> {
    this.isBusy = true;
    while (this.waiting) {
      const { work } = this.waiting;
      this.waiting = null;
      await this.start(work);
    }
    this.isBusy = false;
  }
}
