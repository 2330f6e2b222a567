// The page contains its first scenario, and the names that the core and scenario files share.

export const data = JSON.parse(document.getElementById("data").textContent);
