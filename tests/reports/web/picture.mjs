// Takes the README's picture: node tests/picture.mjs REPORT.html PICTURE.png
import { close, draw_all, open } from "./browser.mjs";

const [report, picture] = process.argv.slice(2);
const { page } = await open(report, { width: 1600, height: 1730 });
await draw_all(page);
await page.evaluate(() => scrollTo(0, 0));
await page.screenshot({ path: picture });
await close();
