// SPDX-License-Identifier: Apache-2.0
// A drag of something that is found where the pointer goes down. It is one step of the history; Escape ends it where it began.

const still = 3; // [px] that a press may move and is no drag

export interface Drag {
  /** Places are as far from where the drag began, right and down. */
  moved: (dx: number, dy: number, gesture: object) => void;
  ended?: () => void;
}

/** `begin`: what is dragged, or nothing. */
export function drags(place: HTMLElement, begin: (event: PointerEvent) => Drag | null): void {
  place.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const drag = begin(event);
    if (!drag) return;
    event.preventDefault();
    place.setPointerCapture(event.pointerId);
    follow(place, event, drag);
  });
}

function follow(place: HTMLElement, { pointerId, clientX, clientY }: PointerEvent, { moved, ended }: Drag): void {
  const gesture = {};
  let isMoved = false;
  const move = (event: PointerEvent) => {
    if (event.pointerId !== pointerId) return;
    const [dx, dy] = [event.clientX - clientX, event.clientY - clientY];
    isMoved ||= Math.hypot(dx, dy) > still;
    if (isMoved) moved(dx, dy, gesture);
  };
  const stop = () => {
    end.abort();
    ended?.();
  };
  const end = new AbortController();
  const { signal } = end;
  place.addEventListener('pointermove', move, { signal });
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture']) place.addEventListener(type, stop, { signal });
  window.addEventListener('keydown', (event) => event.key === 'Escape' && (isMoved && moved(0, 0, gesture), stop()), { signal });
}
