// picture.mjs REPORT.html PICTURE.png [HASH]: a picture of the page as it opens, or as the link behind the # says.
import { launch, openReport } from "./support.mjs";

const [report, picture, hash = ""] = process.argv.slice(2);
const browser = await launch();
const page = await openReport(browser, { html: report }, { hash, viewport: { width: 1280, height: 810 }, colorScheme: "light" });
await page.screenshot({ path: picture });
await browser.close();
if (page.errors.length > 0) throw new Error(page.errors.join("\n"));
