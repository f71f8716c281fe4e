// Takes the picture of the README: node tests/picture.mjs REPORT.html PICTURE.png
import { close, open } from "./browser.mjs";

const [report, picture] = process.argv.slice(2);
const { page } = await open(report, { width: 1600, height: 1730 });
await page.waitForFunction(() =>
  [...document.querySelectorAll(".canvas")].every((chart) => chart.style.minHeight === "" || chart.getBoundingClientRect().top > innerHeight));
await page.screenshot({ path: picture });
await close();
