const data = document.getElementById("plumb-data");
const page = document.getElementById("page");
if (page) page.textContent = data?.textContent ?? "This page holds no report.";
