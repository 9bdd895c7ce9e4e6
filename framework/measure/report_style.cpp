#include "framework/measure/report_page.h"

namespace luch {

std::string page_style() {
    return R"(<style>
:root{color-scheme:light dark;--paper:#f6f7f9;--card:#fff;--ink:#1c2128;--soft:#57606a;--line:#d8dee4;
--accent:#0067a8;--good:#00704f;--good-back:#dff5ec;--warn:#8a5300;--warn-back:#fdf0d5;--bad:#b3001b;
--bad-back:#fde4e6}
@media (prefers-color-scheme:dark){:root{--paper:#101316;--card:#1b1f24;--ink:#e6eaef;--soft:#a9b3be;
--line:#343c45;--accent:#5cb8f0;--good:#5cdba9;--good-back:#12352a;--warn:#f2c76b;--warn-back:#3a2e12;
--bad:#ff8a95;--bad-back:#431a20}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);
font:18px/1.5 system-ui,"Segoe UI","DejaVu Sans",sans-serif}
header,main,footer{max-width:1360px;margin:0 auto;padding:0 32px}
header{padding-top:40px}h1{font-size:40px;line-height:1.15;margin:0 0 8px;letter-spacing:-.02em}
h2{font-size:30px;line-height:1.2;margin:0;letter-spacing:-.01em}
h2 small{font-size:17px;font-weight:400;color:var(--soft);letter-spacing:0;margin-left:12px}
h3{font-size:21px;margin:36px 0 12px}a{color:var(--accent)}
.lead,.soft{color:var(--soft)}.lead{margin:0;font-size:20px}.soft{font-size:16px}
section{background:var(--card);border:1px solid var(--line);border-radius:14px;padding:32px;margin:28px 0}
.verdicts{list-style:none;padding:0;margin:16px 0 24px;display:grid;gap:8px}
.verdicts li{border-left:5px solid var(--accent);padding:6px 16px;font-size:20px;background:var(--paper);
border-radius:0 8px 8px 0}
.findings{margin:12px 0;padding-left:22px;font-size:17px}.findings li{margin:4px 0}
.findings .warning{list-style:"⚠ ";background:var(--warn-back);color:var(--warn);border-radius:6px;padding:2px 8px}
.bar{display:flex;flex-wrap:wrap;gap:8px 22px;align-items:center;margin:8px 0 12px;font-size:16px}
.bar label{color:var(--soft);max-width:100%}select{font:inherit;color:var(--ink);background:var(--paper);
border:1px solid var(--line);border-radius:6px;padding:3px 8px;max-width:100%}
.live .u-legend{font-size:16px;color:var(--ink)}.live .u-over{overflow:visible}
.tip{position:absolute;pointer-events:none;background:var(--ink);color:var(--card);border-radius:6px;
padding:4px 10px;font-size:15px;width:max-content;max-width:90%;z-index:5}
.stack{position:relative;max-width:900px;touch-action:none;cursor:ew-resize;--at:50%}
.stack img{display:block;width:100%;image-rendering:pixelated;border-radius:8px;user-select:none}
.stack .over{position:absolute;inset:0;clip-path:inset(0 0 0 var(--at))}
.stack::after{content:"";position:absolute;top:0;bottom:0;left:var(--at);width:2px;margin-left:-1px;background:#fff;
box-shadow:0 0 0 1px #000a}.compare input{width:100%;max-width:900px;margin:10px 0 0;accent-color:var(--accent)}
[hidden]{display:none!important}
.plot svg{display:block;width:100%;height:auto}.plot{margin:0}
.wide{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:16px;font-variant-numeric:tabular-nums}
th,td{padding:7px 9px;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th{color:var(--soft);font-weight:600;vertical-align:bottom}
th:first-child,td:first-child,th.text,td.text{text-align:left}td.why{white-space:normal;text-align:left}
tr.truth td{border-bottom:2px solid var(--line);color:var(--soft)}tr.group td{border-top:2px solid var(--line)}
td.lead-number{font-weight:650;color:var(--ink)}
.badge{display:inline-block;padding:1px 9px;border-radius:99px;font-size:14px;font-weight:600}
.exact{background:var(--good-back);color:var(--good)}.bounded{background:var(--warn-back);color:var(--warn)}
.heuristic,.bad{background:var(--bad-back);color:var(--bad)}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(270px,1fr));gap:20px;
margin-bottom:20px}
.pictures figure{margin:0;scroll-margin-top:20px}.pictures img{width:100%;display:block;border-radius:8px;
background:#000;image-rendering:auto}
figcaption{font-size:16px;color:var(--soft);padding-top:6px}figcaption b{color:var(--ink)}
.pictures figure:target{position:fixed;inset:0;z-index:9;background:#000e;padding:24px;display:flex;
flex-direction:column;align-items:center;justify-content:center}
.pictures figure:target img{width:auto;min-width:50vw;max-width:96vw;max-height:84vh;object-fit:contain;
image-rendering:pixelated}.pictures figure:target figcaption,.pictures figure:target b{color:#fff}
.close{display:none}figure:target .close{display:block;position:absolute;inset:0}
.legend{max-width:420px;margin:20px 0 0}.legend i{display:block;height:16px;border-radius:4px}
.legend div{position:relative;height:24px;font-size:14px;color:var(--soft)}
.legend span{position:absolute;transform:translateX(-50%)}
section>h2+.facts{margin-top:16px}.facts{display:grid;grid-template-columns:max-content 1fr;gap:4px 20px;margin:0}
.facts dt{color:var(--soft)}.facts dd{margin:0}
code{font:15px/1.5 ui-monospace,"DejaVu Sans Mono",monospace;background:var(--paper);padding:2px 8px;
border-radius:6px;overflow-wrap:anywhere}.glance .wide{margin-top:16px}
footer{padding-bottom:56px}
@media print{body{background:#fff;font-size:12px}section{break-inside:avoid-page;border:0;padding:0}}
</style>
)";
}

}  // namespace luch
