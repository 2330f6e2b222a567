// The page contains its first scenario, the names that the core and scenario files share, and the meanings of the constants.

const data = JSON.parse(document.getElementById("data").textContent);
