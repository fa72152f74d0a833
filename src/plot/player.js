"use strict";
// Shows frame after frame; the slider is the one place that knows which.
(() => {
  const { frames, clocks } = JSON.parse(document.getElementById("frames").textContent);
  const [image, slider, clock, button, rate] = ["frame", "slider", "clock", "play", "rate"].map((id) => document.getElementById(id));
  let timer = null;
  let untouched = true; // the frame shown at first is a cover, not where a film begins
  const decoded = frames.map((uri) => Object.assign(new Image(), { src: uri })); // held, so that no frame flickers

  const show = () => {
    const k = Number(slider.value);
    image.src = decoded[k].src;
    image.dataset.frame = String(k);
    clock.textContent = clocks[k];
  };
  const pause = () => {
    clearInterval(timer);
    timer = null;
    button.textContent = "\u25B6";
    button.setAttribute("aria-label", "play");
  };
  const step = () => {
    if (Number(slider.value) >= frames.length - 1) return pause();
    slider.value = String(Number(slider.value) + 1);
    show();
  };
  const play = () => {
    if (untouched || Number(slider.value) >= frames.length - 1) slider.value = "0";
    untouched = false;
    show();
    clearInterval(timer);
    timer = setInterval(step, 1000 / Number(rate.value));
    button.textContent = "\u275A\u275A";
    button.setAttribute("aria-label", "pause");
  };
  slider.addEventListener("input", () => { untouched = false; pause(); show(); });
  button.addEventListener("click", () => (timer === null ? play() : pause()));
  rate.addEventListener("change", () => { if (timer !== null) play(); });
  show();
})();
