"use strict";(()=>{var d_="uplot",f_="u-hz",p_="u-vt",m_="u-title",g_="u-wrap",__="u-under",x_="u-over",y_="u-axis",tr="u-off",v_="u-select",S_="u-cursor-x",M_="u-cursor-y",b_="u-cursor-pt",w_="u-legend",E_="u-live",T_="u-inline",A_="u-series",C_="u-marker",Of="u-label",R_="u-value",Bo="width",zo="height";var Bf="bottom",Rr="left",$h="right",uu="#000",zf=uu+"0",Zh="mousemove",kf="mousedown",Jh="mouseup",Gf="mouseenter",Vf="mouseleave",Hf="dblclick",P_="resize",I_="scroll",Wf="change",nl="dppxchange",du="--",Fr=typeof window<"u",eu=Fr?document:null,Ir=Fr?window:null,L_=Fr?navigator:null,Pe,ja;function nu(){let i=devicePixelRatio;Pe!=i&&(Pe=i,ja&&su(Wf,ja,nu),ja=matchMedia(`(min-resolution: ${Pe-.001}dppx) and (max-resolution: ${Pe+.001}dppx)`),er(Wf,ja,nu),Ir.dispatchEvent(new CustomEvent(nl)))}function ei(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function iu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function $e(i,t,e){i.style[t]=e+"px"}function Ei(i,t,e,n){let s=eu.createElement(i);return t!=null&&ei(s,t),e?.insertBefore(s,n),s}function gi(i,t){return Ei("div",i,t)}var Xf=new WeakMap;function Wi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Xf.get(i);r!=o&&(i.style.transform=r,Xf.set(i,r),t<0||e<0||t>n||e>s?ei(i,tr):iu(i,tr))}var qf=new WeakMap;function Yf(i,t,e){let n=t+e,s=qf.get(i);n!=s&&(qf.set(i,n),i.style.background=t,i.style.borderColor=e)}var $f=new WeakMap;function Zf(i,t,e,n){let s=t+""+e,r=$f.get(i);s!=r&&($f.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var fu={passive:!0},D_={...fu,capture:!0};function er(i,t,e,n){t.addEventListener(i,e,n?D_:fu)}function su(i,t,e,n){t.removeEventListener(i,e,fu)}Fr&&nu();function Ti(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ni((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function bp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var wp=i=>i!=null,Ep=i=>i!=null&&i>0,rl=bp(wp),N_=bp(Ep);function U_(i,t,e,n=0,s=!1){let r=s?N_:rl,o=s?Ep:wp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ve,l??-Ve]}function ol(i,t,e,n){let s=jf(i),r=jf(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?rs:Tp,a=s==1?ni:_i,l=r==1?_i:ni,c=a(o(gn(i))),h=l(o(gn(t))),d=Lr(e,c),u=Lr(e,h);return e==10&&(c<0&&(d=He(d,-c)),h<0&&(u=He(u,-h))),n||e==2?(i=d*s,t=u*r):(i=Pp(i,d),t=al(t,u)),[i,t]}function pu(i,t,e,n){let s=ol(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var mu=.1,Jf={mode:3,pad:mu},Go={pad:0,soft:null,mode:0},F_={min:Go,max:Go};function il(i,t,e,n){return ll(e)?Kf(i,t,e):(Go.pad=e,Go.soft=n?0:null,Go.mode=n?3:0,Kf(i,t,F_))}function Ae(i,t){return i??t}function O_(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Kf(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),o=Ae(s.pad,0),a=Ae(n.hard,-Ve),l=Ae(s.hard,Ve),c=Ae(n.soft,Ve),h=Ae(s.soft,-Ve),d=Ae(n.mode,0),u=Ae(s.mode,0),p=t-i,g=rs(p),S=kn(gn(i),gn(t)),m=rs(S),f=gn(m-g);(p<1e-24||f>10)&&(p=0,(i==0||t==0)&&(p=1e-24,d==2&&c!=Ve&&(r=0),u==2&&h!=-Ve&&(o=0)));let M=p||S||1e3,R=rs(M),v=Lr(10,ni(R)),C=M*(p==0?i==0?.1:1:r),A=He(Pp(i-C,v/10),24),_=i>=c&&(d==1||d==3&&A<=c||d==2&&A>=c)?c:Ve,E=kn(a,A<_&&i>=_?_:Ai(_,A)),B=M*(p==0?t==0?.1:1:o),N=He(al(t+B,v/10),24),D=t<=h&&(u==1||u==3&&N>=h||u==2&&N<=h)?h:-Ve,z=Ai(l,N>D&&t<=D?D:kn(D,N));return E==z&&E==0&&(z=100),[E,z]}var B_=new Intl.NumberFormat(Fr?L_.language:"en-US"),gu=i=>B_.format(i),ii=Math,el=ii.PI,gn=ii.abs,ni=ii.floor,mn=ii.round,_i=ii.ceil,Ai=ii.min,kn=ii.max,Lr=ii.pow,jf=ii.sign,rs=ii.log10,Tp=ii.log2,z_=(i,t=1)=>ii.sinh(i)*t,Kh=(i,t=1)=>ii.asinh(i/t),Ve=1/0;function Qf(i){return(rs((i^i>>31)-(i>>31))|0)+1}function ru(i,t,e){return Ai(kn(i,t),e)}function Ap(i){return typeof i=="function"}function be(i){return Ap(i)?i:()=>i}var k_=()=>{},Cp=i=>i,Rp=(i,t)=>t,G_=i=>null,tp=i=>!0,ep=(i,t)=>i==t,V_=/\.\d*?(?=9{6,}|0{6,})/gm,nr=i=>{if(Lp(i)||Ls.has(i))return i;let t=`${i}`,e=t.match(V_);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${nr(s)}e${r}`}return He(i,n)};function js(i,t){return nr(He(nr(i/t))*t)}function al(i,t){return nr(_i(nr(i/t))*t)}function Pp(i,t){return nr(ni(nr(i/t))*t)}function He(i,t=0){if(Lp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return mn(n)/e}var Ls=new Map;function Ip(i){return((""+i).split(".")[1]||"").length}function Ho(i,t,e,n){let s=[],r=n.map(Ip);for(let o=t;o<e;o++){let a=gn(o),l=He(Lr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:He(h,d);s.push(u),Ls.set(u,d)}}return s}var Vo={},_u=[],Dr=[null,null],Is=Array.isArray,Lp=Number.isInteger,H_=i=>i===void 0;function np(i){return typeof i=="string"}function ll(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function W_(i){return i!=null&&typeof i=="object"}var X_=Object.getPrototypeOf(Uint8Array),Dp="__proto__";function Nr(i,t=ll){let e;if(Is(i)){let n=i.find(s=>s!=null);if(Is(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Nr(i[s],t)}else e=i.slice()}else if(i instanceof X_)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Dp&&(e[n]=Nr(i[n],t))}else e=i;return e}function dn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Dp&&(ll(i[s])?dn(i[s],Nr(n[s])):i[s]=Nr(n[s]))}return i}var q_=0,Y_=1,$_=2;function Z_(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function J_(i,t){if(Q_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return tx(o[0])||(o=j_(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=t?t[o][c]:Y_,p=[];for(let g=0;g<h.length;g++){let S=h[g],m=r.get(l[g]);S===null?u!=q_&&(d[m]=S,u==$_&&p.push(m)):d[m]=S}Z_(d,p,s),n.push(d)}}return n}var K_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function j_(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Q_(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function tx(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=kn(1,ni((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Np=["January","February","March","April","May","June","July","August","September","October","November","December"],Up=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Fp(i){return i.slice(0,3)}var ex=Up.map(Fp),nx=Np.map(Fp),ix={MMMM:Np,MMM:nx,WWWW:Up,WWW:ex};function Oo(i){return(i<10?"0":"")+i}function sx(i){return(i<10?"00":i<100?"0":"")+i}var rx={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Oo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Oo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Oo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Oo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Oo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>sx(i.getMilliseconds())};function xu(i,t){t=t||ix;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?rx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var ox=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ax(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==ox?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Op=i=>i%1==0,sl=[1,2,2.5,5],lx=Ho(10,-32,0,sl),Bp=Ho(10,0,32,sl),cx=Bp.filter(Op),Qs=lx.concat(Bp),yu=`
`,zp="{YYYY}",ip=yu+zp,kp="{M}/{D}",ko=yu+kp,Qa=ko+"/{YY}",Gp="{aa}",hx="{h}:{mm}",Pr=hx+Gp,sp=yu+Pr,rp=":{ss}",De=null;function Vp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ho(10,0,3,sl).filter(Op):Ho(10,-3,0,sl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,zp,De,De,De,De,De,De,1],[s*28,"{MMM}",ip,De,De,De,De,De,1],[s,kp,ip,De,De,De,De,De,1],[n,"{h}"+Gp,Qa,De,ko,De,De,De,1],[e,Pr,Qa,De,ko,De,De,De,1],[t,rp,Qa+" "+Pr,De,ko+" "+Pr,De,sp,De,1],[i,rp+".{fff}",Qa+" "+Pr,De,ko+" "+Pr,De,sp,De,1]];function h(d){return(u,p,g,S,m,f)=>{let M=[],R=m>=o,v=m>=r&&m<o,C=d(g),A=He(C*i,3),_=jh(C.getFullYear(),R?0:C.getMonth(),v||R?1:C.getDate()),E=He(_*i,3);if(v||R){let B=v?m/r:0,N=R?m/o:0,D=A==E?A:He(jh(_.getFullYear()+N,_.getMonth()+B,1)*i,3),z=new Date(mn(D/i)),W=z.getFullYear(),L=z.getMonth();for(let V=0;D<=S;V++){let q=jh(W+N*V,L+B*V,1),H=q-d(He(q*i,3));D=He((+q+H)*i,3),D<=S&&M.push(D)}}else{let B=m>=s?s:m,N=ni(g)-ni(A),D=E+N+al(A-E,B);M.push(D);let z=d(D),W=z.getHours()+z.getMinutes()/e+z.getSeconds()/n,L=m/n,V=u.axes[p]._space,q=f/V;for(;D=He(D+m,i==1?0:3),!(D>S);)if(L>1){let H=ni(He(W+L,6))%24,j=d(D).getHours()-H;j>1&&(j=-1),D-=j*n,W=(W+L)%24;let it=M[M.length-1];He((D-it)/m,3)*q>=.7&&M.push(D)}else M.push(D)}return M}}return[l,c,h]}var[ux,dx,fx]=Vp(1),[px,mx,gx]=Vp(.001);Ho(2,-53,53,[1]);function op(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function ap(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,d,u,p;return n.map(g=>{let S=i(g),m=S.getFullYear(),f=S.getMonth(),M=S.getDate(),R=S.getHours(),v=S.getMinutes(),C=S.getSeconds(),A=m!=l&&a[2]||f!=c&&a[3]||M!=h&&a[4]||R!=d&&a[5]||v!=u&&a[6]||C!=p&&a[7]||a[1];return l=m,c=f,h=M,d=R,u=v,p=C,A(S)})}}function _x(i,t){let e=xu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function jh(i,t,e){return new Date(i,t,e)}function lp(i,t){return t(i)}var xx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cp(i,t){return(e,n,s,r)=>r==null?du:t(i(n))}function yx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function vx(i,t){return i.series[t].fill(i,t)}var Sx={show:!0,live:!0,isolate:!1,mount:k_,markers:{show:!0,width:2,stroke:yx,fill:vx,dash:"solid"},idx:null,idxs:null,values:[]};function Mx(i,t){let e=i.cursor.points,n=gi(),s=e.size(i,t);$e(n,Bo,s),$e(n,zo,s);let r=s/-2;$e(n,"marginLeft",r),$e(n,"marginTop",r);let o=e.width(i,t,s);return o&&$e(n,"borderWidth",o),n}function bx(i,t){let e=i.series[t].points;return e._fill||e._stroke}function wx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Ex(i,t){return i.series[t].points.size}var Qh=[0,0];function Tx(i,t,e){return Qh[0]=t,Qh[1]=e,Qh}function tl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function tu(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var Ax={show:!0,x:!0,y:!0,lock:!1,move:Tx,points:{one:!1,show:Mx,size:Ex,width:0,stroke:wx,fill:bx},bind:{mousedown:tl,mouseup:tl,click:tl,dblclick:tl,mousemove:tu,mouseleave:tu,mouseenter:tu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Hp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},vu=dn({},Hp,{filter:Rp}),Wp=dn({},vu,{size:10}),Xp=dn({},Hp,{show:!1}),Su='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',qp="bold "+Su,Yp=1.5,hp={show:!0,scale:"x",stroke:uu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qp,side:2,grid:vu,ticks:Wp,border:Xp,font:Su,lineGap:Yp,rotate:0},Cx="Value",Rx="Time",up={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function Px(i,t,e,n,s){return t.map(r=>r==null?"":gu(r))}function Ix(i,t,e,n,s,r,o){let a=[],l=Ls.get(s)||0;e=o?e:He(al(e,s),l);for(let c=e;c<=n;c=He(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ou(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?rs:Tp,h=ni(c(e));s=Lr(l,h),l==10&&(s=Qs[Ti(s,Qs)]);let d=e,u=s*l;l==10&&(u=Qs[Ti(u,Qs)]);do a.push(d),d=d+s,l==10&&!Ls.has(d)&&(d=He(d,Ls.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Qs[Ti(u,Qs)]));while(d<=n);return a}function Lx(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?ou(i,t,kn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?ou(i,t,kn(l,-n),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var $p=/./,Dx=/[12357]/,Nx=/[125]/,dp=/1/,au=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Ux(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?$p:l(7,o)-h>=c?Dx:l(5,o)-h>=c?Nx:dp;if(d==dp){let u=gn(l(1,o)-h);if(u<c)return au(t.slice().reverse(),a.distr,d,_i(c/u)).reverse()}return au(t,a.distr,d,1)}function Fx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=gn(l(1,o)-l(2,o));return c<a?au(t.slice().reverse(),3,$p,_i(a/c)).reverse():t}function Ox(i,t,e,n){return n==null?du:t==null?"":gu(t)}var fp={show:!0,scale:"y",stroke:uu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qp,side:3,grid:vu,ticks:Wp,border:Xp,font:Su,lineGap:Yp,rotate:0};function Bx(i,t){let e=3+(i||1)*2;return He(e*t,3)}function zx(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=gn(o-r),l=i.series[t],c=a/(l.points.space*Pe);return n[1]-n[0]<=c}var pp={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},Zp=(i,t,e,n,s)=>s,mp={show:!0,auto:!0,sorted:0,gaps:Zp,alpha:1,facets:[dn({},pp,{scale:"x"}),dn({},pp,{scale:"y"})]},gp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Zp,alpha:1,points:{show:zx,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function kx(i,t,e,n,s){return e/10}var Jp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Gx=dn({},Jp,{time:!1,ori:1}),_p={};function Kp(i,t){let e=_p[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(_p[i]=e)),e}var Ur=1,lu=2;function ir(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,p=a.top,g=a.width,S=a.height,m=i.valToPosH,f=i.valToPosV;return h.ori==0?e(s,l,c,h,d,m,f,u,p,g,S,hl,Or,dl,Qp,em):e(s,l,c,h,d,f,m,p,u,S,g,ul,Br,wu,tm,nm)}function Mu(i,t){let e=0,n=0,s=Ae(i.bands,_u);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Vx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function os(i,t,e,n,s,r){return ir(i,t,(o,a,l,c,h,d,u,p,g,S,m)=>{let f=o.pxRound,M=c.dir*(c.ori==0?1:-1),R=c.ori==0?Or:Br,v,C;M==1?(v=e,C=n):(v=n,C=e);let A=f(d(a[v],c,S,p)),_=f(u(l[v],h,m,g)),E=f(d(a[C],c,S,p)),B=f(u(r==1?h.max:h.min,h,m,g)),N=new Path2D(s);return R(N,E,B),R(N,A,B),R(N,A,_),N})}function cl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?dl:wu,l=e;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let p=u[0]-l;p>0&&a(o,l,n,p,n+r),l=u[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Hx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function bu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let p=r(i[d]),g=u==d?p:r(i[u]),S=d-s;p=o<=0&&S>=0&&S<l?r(i[S]):p;let f=u+s;g=o>=0&&f>=0&&f<l?r(i[f]):g,g>=p&&a.push([p,g])}return a}function xp(i){return i==0?Cp:i==1?mn:t=>js(t,i)}function jp(i){let t=i==0?hl:ul,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ai(c,a/2,l/2),h=Ai(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var hl=(i,t,e)=>{i.moveTo(t,e)},ul=(i,t,e)=>{i.moveTo(e,t)},Or=(i,t,e)=>{i.lineTo(t,e)},Br=(i,t,e)=>{i.lineTo(e,t)},dl=jp(0),wu=jp(1),Qp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},tm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},em=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},nm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function im(i){return(t,e,n,s,r)=>ir(t,e,(o,a,l,c,h,d,u,p,g,S,m)=>{let{pxRound:f,points:M}=o,R,v;c.ori==0?(R=hl,v=Qp):(R=ul,v=tm);let C=He(M.width*Pe,3),A=(M.size-M.width)/2*Pe,_=He(A*2,3),E=new Path2D,B=new Path2D,{left:N,top:D,width:z,height:W}=t.bbox;dl(B,N-_,D-_,z+_*2,W+_*2);let L=V=>{if(l[V]!=null){let q=f(d(a[V],c,S,p)),H=f(u(l[V],h,m,g));R(E,q+A,H),v(E,q,H,A,0,el*2)}};if(r)r.forEach(L);else for(let V=n;V<=s;V++)L(V);return{stroke:C>0?E:null,fill:E,clip:B,flags:Ur|lu}})}function sm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Wx=sm(Or),Xx=sm(Br);function rm(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>ir(e,n,(o,a,l,c,h,d,u,p,g,S,m)=>{[s,r]=rl(l,s,r);let f=o.pxRound,M=W=>f(d(W,c,S,p)),R=W=>f(u(W,h,m,g)),v,C;c.ori==0?(v=Or,C=Wx):(v=Br,C=Xx);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ur},E=_.stroke,B=!1;if(r-s>=S*4){let W=ht=>e.posToVal(ht,c.key,!0),L=null,V=null,q,H,ct,Y=M(a[A==1?s:r]),j=M(a[s]),it=M(a[r]),pt=W(A==1?j+1:it-1);for(let ht=A==1?s:r;ht>=s&&ht<=r;ht+=A){let tt=a[ht],Mt=(A==1?tt<pt:tt>pt)?Y:M(tt),Lt=l[ht];Mt==Y?Lt!=null?(H=Lt,L==null?(v(E,Mt,R(H)),q=L=V=H):H<L?L=H:H>V&&(V=H)):Lt===null&&(B=!0):(L!=null&&C(E,Y,R(L),R(V),R(q),R(H)),Lt!=null?(H=Lt,v(E,Mt,R(H)),L=V=q=H):(L=V=null,Lt===null&&(B=!0)),Y=Mt,pt=W(Y+A))}L!=null&&L!=V&&ct!=Y&&C(E,Y,R(L),R(V),R(q),R(H))}else for(let W=A==1?s:r;W>=s&&W<=r;W+=A){let L=l[W];L===null?B=!0:L!=null&&v(E,M(a[W]),R(L))}let[D,z]=Mu(e,n);if(o.fill!=null||D!=0){let W=_.fill=new Path2D(E),L=o.fillTo(e,n,o.min,o.max,D),V=R(L),q=M(a[s]),H=M(a[r]);A==-1&&([H,q]=[q,H]),v(W,H,V),v(W,q,V)}if(!o.spanGaps){let W=[];B&&W.push(...bu(a,l,s,r,A,M,t)),_.gaps=W=o.gaps(e,n,s,r,W),_.clip=cl(W,c.ori,p,g,S,m)}return z!=0&&(_.band=z==2?[os(e,n,s,r,E,-1),os(e,n,s,r,E,1)]:os(e,n,s,r,E,z)),_})}function qx(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,o,a,l)=>ir(r,o,(c,h,d,u,p,g,S,m,f,M,R)=>{[a,l]=rl(d,a,l);let v=c.pxRound,{left:C,width:A}=r.bbox,_=j=>v(g(j,u,M,m)),E=j=>v(S(j,p,R,f)),B=u.ori==0?Or:Br,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ur},D=N.stroke,z=u.dir*(u.ori==0?1:-1),W=E(d[z==1?a:l]),L=_(h[z==1?a:l]),V=L,q=L;s&&t==-1&&(q=C,B(D,q,W)),B(D,L,W);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let it=d[j];if(it==null)continue;let pt=_(h[j]),ht=E(it);t==1?B(D,pt,W):B(D,V,ht),B(D,pt,ht),W=ht,V=pt}let H=V;s&&t==1&&(H=C+A,B(D,H,W));let[ct,Y]=Mu(r,o);if(c.fill!=null||ct!=0){let j=N.fill=new Path2D(D),it=c.fillTo(r,o,c.min,c.max,ct),pt=E(it);B(j,H,pt),B(j,q,pt)}if(!c.spanGaps){let j=[];j.push(...bu(h,d,a,l,z,_,n));let it=c.width*Pe/2,pt=e||t==1?it:-it,ht=e||t==-1?-it:it;j.forEach(tt=>{tt[0]+=pt,tt[1]+=ht}),N.gaps=j=c.gaps(r,o,a,l,j),N.clip=cl(j,u.ori,m,f,M,R)}return Y!=0&&(N.band=Y==2?[os(r,o,a,l,D,-1),os(r,o,a,l,D,1)]:os(r,o,a,l,D,Y)),N})}function yp(i,t,e,n,s,r,o=Ve){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=gn(i[l]-i[a]);h<c&&(c=h,o=gn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Yx(i){i=i||Vo;let t=Ae(i.size,[.6,Ve,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Ae(t[1],Ve),l=Ae(t[2],1),c=Ae(i.disp,Vo),h=Ae(i.each,p=>{}),{fill:d,stroke:u}=c;return(p,g,S,m)=>ir(p,g,(f,M,R,v,C,A,_,E,B,N,D)=>{let z=f.pxRound,W=e,L=n*Pe,V=a*Pe,q=l*Pe,H,ct;v.ori==0?[H,ct]=r(p,g):[ct,H]=r(p,g);let Y=v.dir*(v.ori==0?1:-1),j=v.ori==0?dl:wu,it=v.ori==0?h:(ut,kt,Ut,yt,Xt,Et,Gt)=>{h(ut,kt,Ut,Xt,yt,Gt,Et)},pt=Ae(p.bands,_u).find(ut=>ut.series[0]==g),ht=pt!=null?pt.dir:0,tt=f.fillTo(p,g,f.min,f.max,ht),gt=z(_(tt,C,D,B)),Mt,Lt,At,jt=N,he=z(f.width*Pe),Jt=!1,de=null,fe=null,re=null,Ue=null;d!=null&&(he==0||u!=null)&&(Jt=!0,de=d.values(p,g,S,m),fe=new Map,new Set(de).forEach(ut=>{ut!=null&&fe.set(ut,new Path2D)}),he>0&&(re=u.values(p,g,S,m),Ue=new Map,new Set(re).forEach(ut=>{ut!=null&&Ue.set(ut,new Path2D)})));let{x0:Le,size:We}=c;if(Le!=null&&We!=null){W=1,M=Le.values(p,g,S,m),Le.unit==2&&(M=M.map(Ut=>p.posToVal(E+Ut*N,v.key,!0)));let ut=We.values(p,g,S,m);We.unit==2?Lt=ut[0]*N:Lt=A(ut[0],v,N,E)-A(0,v,N,E),jt=yp(M,R,A,v,N,E,jt),At=jt-Lt+L}else jt=yp(M,R,A,v,N,E,jt),At=jt*o+L,Lt=jt-At;At<1&&(At=0),he>=Lt/2&&(he=0),At<5&&(z=Cp);let K=At>0,dt=jt-At-(K?he:0);Lt=z(ru(dt,q,V)),Mt=(W==0?Lt/2:W==Y?0:Lt)-W*Y*((W==0?L/2:0)+(K?he/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},bt=Jt?null:new Path2D,_t=null;if(pt!=null)_t=p.data[pt.series[1]];else{let{y0:ut,y1:kt}=c;ut!=null&&kt!=null&&(R=kt.values(p,g,S,m),_t=ut.values(p,g,S,m))}let Yt=H*Lt,P=ct*Lt;for(let ut=Y==1?S:m;ut>=S&&ut<=m;ut+=Y){let kt=R[ut];if(kt==null)continue;if(_t!=null){let k=_t[ut]??0;if(kt-k==0)continue;gt=_(k,C,D,B)}let Ut=v.distr!=2||c!=null?M[ut]:ut,yt=A(Ut,v,N,E),Xt=_(Ae(kt,tt),C,D,B),Et=z(yt-Mt),Gt=z(kn(Xt,gt)),T=z(Ai(Xt,gt)),y=Gt-T;if(kt!=null){let k=kt<0?P:Yt,st=kt<0?Yt:P;Jt?(he>0&&re[ut]!=null&&j(Ue.get(re[ut]),Et,T+ni(he/2),Lt,kn(0,y-he),k,st),de[ut]!=null&&j(fe.get(de[ut]),Et,T+ni(he/2),Lt,kn(0,y-he),k,st)):j(bt,Et,T+ni(he/2),Lt,kn(0,y-he),k,st),it(p,g,ut,Et-he/2,T,Lt+he,y)}}return he>0?xt.stroke=Jt?Ue:bt:Jt||(xt._fill=f.width==0?f._fill:f._stroke??f._fill,xt.width=0),xt.fill=Jt?fe:bt,xt})}function $x(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,o)=>ir(n,s,(a,l,c,h,d,u,p,g,S,m,f)=>{[r,o]=rl(c,r,o);let M=a.pxRound,R=H=>M(u(H,h,m,g)),v=H=>M(p(H,d,f,S)),C,A,_;h.ori==0?(C=hl,_=Or,A=em):(C=ul,_=Br,A=nm);let E=h.dir*(h.ori==0?1:-1),B=R(l[E==1?r:o]),N=B,D=[],z=[];for(let H=E==1?r:o;H>=r&&H<=o;H+=E)if(c[H]!=null){let Y=l[H],j=R(Y);D.push(N=j),z.push(v(c[H]))}let W={stroke:i(D,z,C,_,A,M),fill:null,clip:null,band:null,gaps:null,flags:Ur},L=W.stroke,[V,q]=Mu(n,s);if(a.fill!=null||V!=0){let H=W.fill=new Path2D(L),ct=a.fillTo(n,s,a.min,a.max,V),Y=v(ct);_(H,N,Y),_(H,B,Y)}if(!a.spanGaps){let H=[];H.push(...bu(l,c,r,o,E,R,e)),W.gaps=H=a.gaps(n,s,r,o,H),W.clip=cl(H,h.ori,g,S,m,f)}return q!=0&&(W.band=q==2?[os(n,s,r,o,L,-1),os(n,s,r,o,L,1)]:os(n,s,r,o,L,q)),W})}function Zx(i){return $x(Jx,i)}function Jx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,t[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,i[u+1],t[u+1])}return a}var cu=new Set;function vp(){for(let i of cu)i.syncRect(!0)}Fr&&(er(P_,Ir,vp),er(I_,Ir,vp,!0),er(nl,Ir,()=>{_n.pxRatio=Pe}));var Kx=rm(),jx=im();function Sp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>hu(r,o,t,e))}function Qx(i,t){return i.map((e,n)=>n==0?{}:dn({},t,e))}function hu(i,t,e,n){return dn({},t==0?e:n,i)}function om(i,t,e){return t==null?Dr:[t,e]}var ty=om;function ey(i,t,e){return t==null?Dr:il(t,e,mu,!0)}function am(i,t,e,n){return t==null?Dr:ol(t,e,i.scales[n].log,!1)}var ny=am;function lm(i,t,e,n){return t==null?Dr:pu(t,e,i.scales[n].log,!1)}var iy=lm;function sy(i,t,e,n,s){let r=kn(Qf(i),Qf(t)),o=t-i,a=Ti(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Ls.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Mp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=mn((e=+s)*Pe))+"px"),[i,t,e]}function ry(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=He(t[2]*Pe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function _n(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(x,b,I,U){let X=b.valToPct(x);return U+I*(b.dir==-1?1-X:X)}function o(x,b,I,U){let X=b.valToPct(x);return U+I*(b.dir==-1?X:1-X)}function a(x,b,I,U){return b.ori==0?r(x,b,I,U):o(x,b,I,U)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=gi(d_);if(i.id!=null&&(c.id=i.id),ei(c,i.class),i.title){let x=gi(m_,c);x.textContent=i.title}let h=Ei("canvas"),d=n.ctx=h.getContext("2d"),u=gi(g_,c);er("click",u,x=>{x.target===g&&(Xe!=wr||Je!=Er)&&Rn.click(n,x)},!0);let p=n.under=gi(__,u);u.appendChild(h);let g=n.over=gi(x_,u);i=Nr(i);let S=+Ae(i.pxAlign,1),m=xp(S);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let f=i.ms||.001,M=n.series=s==1?Sp(i.series||[],up,gp,!1):Qx(i.series||[null],mp),R=n.axes=Sp(i.axes||[],hp,fp,!0),v=n.scales={},C=n.bands=i.bands||[];C.forEach(x=>{x.fill=be(x.fill||null),x.dir=Ae(x.dir,-1)});let A=s==2?M[1].facets[0].scale:M[0].scale,_={axes:is,series:ye},E=(i.drawOrder||["axes","series"]).map(x=>_[x]);function B(x){let b=x.distr==3?I=>rs(I>0?I:x.clamp(n,I,x.min,x.max,x.key)):x.distr==4?I=>Kh(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let U=b(I),{_min:X,_max:J}=x,ft=J-X;return(U-X)/ft}}function N(x){let b=v[x];if(b==null){let I=(i.scales||Vo)[x]||Vo;if(I.from!=null){N(I.from);let U=dn({},v[I.from],I,{key:x});U.valToPct=B(U),v[x]=U}else{b=v[x]=dn({},x==A?Jp:Gx,I),b.key=x;let U=b.time,X=b.range,J=Is(X);if((x!=A||s==2&&!U)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Jf:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Jf:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&ll(X))){let ft=X;X=(wt,It,Vt)=>It==null?Dr:il(It,Vt,ft)}b.range=be(X||(U?ty:x==A?b.distr==3?ny:b.distr==4?iy:om:b.distr==3?am:b.distr==4?lm:ey)),b.auto=be(J?!1:b.auto),b.clamp=be(b.clamp||kx),b._min=b._max=null,b.valToPct=B(b)}}}N("x"),N("y"),s==1&&M.forEach(x=>{N(x.scale)}),R.forEach(x=>{N(x.scale)});for(let x in i.scales)N(x);let D=v[A],z=D.distr,W,L;D.ori==0?(ei(c,f_),W=r,L=o):(ei(c,p_),W=o,L=r);let V={};for(let x in v){let b=v[x];(b.min!=null||b.max!=null)&&(V[x]={min:b.min,max:b.max},b.min=b.max=null)}let q=i.tzDate||(x=>new Date(mn(x/f))),H=i.fmtDate||xu,ct=f==1?fx(q):gx(q),Y=ap(q,op(f==1?dx:mx,H)),j=cp(q,lp(xx,H)),it=[],pt=n.legend=dn({},Sx,i.legend),ht=n.cursor=dn({},Ax,{drag:{y:s==2}},i.cursor),tt=pt.show,gt=ht.show,Mt=pt.markers;pt.idxs=it,Mt.width=be(Mt.width),Mt.dash=be(Mt.dash),Mt.stroke=be(Mt.stroke),Mt.fill=be(Mt.fill);let Lt,At,jt,he=[],Jt=[],de,fe=!1,re={};if(pt.live){let x=M[1]?M[1].values:null;fe=x!=null,de=fe?x(n,1,0):{_:0};for(let b in de)re[b]=du}if(tt)if(Lt=Ei("table",w_,c),jt=Ei("tbody",null,Lt),pt.mount(n,Lt),fe){At=Ei("thead",null,Lt,jt);let x=Ei("tr",null,At);Ei("th",null,x);for(var Ue in de)Ei("th",Of,x).textContent=Ue}else ei(Lt,T_),pt.live&&ei(Lt,E_);let Le={show:!0},We={show:!1};function K(x,b){if(b==0&&(fe||!pt.live||s==2))return Dr;let I=[],U=Ei("tr",A_,jt,jt.childNodes[b]);ei(U,x.class),x.show||ei(U,tr);let X=Ei("th",null,U);if(Mt.show){let wt=gi(C_,X);if(b>0){let It=Mt.width(n,b);It&&(wt.style.border=It+"px "+Mt.dash(n,b)+" "+Mt.stroke(n,b)),wt.style.background=Mt.fill(n,b)}}let J=gi(Of,X);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,b>0&&(Mt.show||(J.style.color=x.width>0?Mt.stroke(n,b):Mt.fill(n,b)),xt("click",X,wt=>{if(ht._lock)return;ie(wt);let It=M.indexOf(x);if((wt.ctrlKey||wt.metaKey)!=pt.isolate){let Vt=M.some((Ht,qt)=>qt>0&&qt!=It&&Ht.show);M.forEach((Ht,qt)=>{qt>0&&ki(qt,Vt?qt==It?Le:We:Le,!0,un.setSeries)})}else ki(It,{show:!x.show},!0,un.setSeries)},!1),te&&xt(Gf,X,wt=>{ht._lock||(ie(wt),ki(M.indexOf(x),Ar,!0,un.setSeries))},!1));for(var ft in de){let wt=Ei("td",R_,U);wt.textContent="--",I.push(wt)}return[U,I]}let dt=new Map;function xt(x,b,I,U=!0){let X=dt.get(b)||{},J=ht.bind[x](n,b,I,U);J&&(er(x,b,X[x]=J),dt.set(b,X))}function bt(x,b,I){let U=dt.get(b)||{};for(let X in U)(x==null||X==x)&&(su(X,b,U[X]),delete U[X]);x==null&&dt.delete(b)}let _t=0,Yt=0,P=0,ut=0,kt=0,Ut=0,yt=kt,Xt=Ut,Et=P,Gt=ut,T=0,y=0,k=0,st=0;n.bbox={};let Q=!1,mt=!1,vt=!1,et=!1,rt=!1,St=!1;function F(x,b,I){(I||x!=n.width||b!=n.height)&&at(x,b),ge(!1),vt=!0,mt=!0,Ln()}function at(x,b){n.width=_t=P=x,n.height=Yt=ut=b,kt=Ut=0,Rt(),Qt();let I=n.bbox;T=I.left=js(kt*Pe,.5),y=I.top=js(Ut*Pe,.5),k=I.width=js(P*Pe,.5),st=I.height=js(ut*Pe,.5)}let ot=3;function Pt(){let x=!1,b=0;for(;!x;){b++;let I=Sr(b),U=zi(b);x=b==ot||I&&U,x||(at(n.width,n.height),mt=!0)}}function Tt({width:x,height:b}){F(x,b)}n.setSize=Tt;function Rt(){let x=!1,b=!1,I=!1,U=!1;R.forEach((X,J)=>{if(X.show&&X._show){let{side:ft,_size:wt}=X,It=ft%2,Vt=X.label!=null?X.labelSize:0,Ht=wt+Vt;Ht>0&&(It?(P-=Ht,ft==3?(kt+=Ht,U=!0):I=!0):(ut-=Ht,ft==0?(Ut+=Ht,x=!0):b=!0))}}),Oi[0]=x,Oi[1]=I,Oi[2]=b,Oi[3]=U,P-=Mi[1]+Mi[3],kt+=Mi[3],ut-=Mi[2]+Mi[0],Ut+=Mi[0]}function Qt(){let x=kt+P,b=Ut+ut,I=kt,U=Ut;function X(J,ft){switch(J){case 1:return x+=ft,x-ft;case 2:return b+=ft,b-ft;case 3:return I-=ft,I+ft;case 0:return U-=ft,U+ft}}R.forEach((J,ft)=>{if(J.show&&J._show){let wt=J.side;J._pos=X(wt,J._size),J.label!=null&&(J._lpos=X(wt,J.labelSize))}})}if(ht.dataIdx==null){let x=ht.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let I=x.prox=be(x.prox),U=x.bias??=0;ht.dataIdx=(X,J,ft,wt)=>{if(J==0)return ft;let It=ft,Vt=I(X,J,ft,wt)??Ve,Ht=Vt>=0&&Vt<Ve,qt=D.ori==0?P:ut,pe=ht.left,Re=t[0],Te=t[J];if(b.has(Te[ft])){It=null;let Se=null,le=null,ne;if(U==0||U==-1)for(ne=ft;Se==null&&ne-- >0;)b.has(Te[ne])||(Se=ne);if(U==0||U==1)for(ne=ft;le==null&&ne++<Te.length;)b.has(Te[ne])||(le=ne);if(Se!=null||le!=null)if(Ht){let Ye=Se==null?-1/0:W(Re[Se],D,qt,0),nn=le==null?1/0:W(Re[le],D,qt,0),En=pe-Ye,Ge=nn-pe;En<=Ge?En<=Vt&&(It=Se):Ge<=Vt&&(It=le)}else It=le==null?Se:Se==null?le:ft-Se<=le-ft?Se:le}else Ht&&gn(pe-W(Re[ft],D,qt,0))>Vt&&(It=null);return It}}let ie=x=>{ht.event=x};ht.idxs=it,ht._lock=!1;let lt=ht.points;lt.show=be(lt.show),lt.size=be(lt.size),lt.stroke=be(lt.stroke),lt.width=be(lt.width),lt.fill=be(lt.fill);let Ot=n.focus=dn({},i.focus||{alpha:.3},ht.focus),te=Ot.prox>=0,Ct=te&&lt.one,ae=[],ke=[],In=[];function Ro(x,b){let I=lt.show(n,b);if(I instanceof HTMLElement)return ei(I,b_),ei(I,x.class),Wi(I,-10,-10,P,ut),g.insertBefore(I,ae[b]),I}function xr(x,b){if(s==1||b>0){let I=s==1&&v[x.scale].time,U=x.value;x.value=I?np(U)?cp(q,lp(U,H)):U||j:U||Ox,x.label=x.label||(I?Rx:Cx)}if(Ct||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Kx||G_,x.fillTo=be(x.fillTo||Vx),x.pxAlign=+Ae(x.pxAlign,S),x.pxRound=xp(x.pxAlign),x.stroke=be(x.stroke||null),x.fill=be(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=Bx(kn(1,x.width),1),U=x.points=dn({},{size:I,width:kn(1,I*.2),stroke:x.stroke,space:I*2,paths:jx,_stroke:null,_fill:null},x.points);U.show=be(U.show),U.filter=be(U.filter),U.fill=be(U.fill),U.stroke=be(U.stroke),U.paths=be(U.paths),U.pxAlign=x.pxAlign}if(tt){let I=K(x,b);he.splice(b,0,I[0]),Jt.splice(b,0,I[1]),pt.values.push(null)}if(gt){it.splice(b,0,null);let I=null;Ct?b==0&&(I=Ro(x,b)):b>0&&(I=Ro(x,b)),ae.splice(b,0,I),ke.splice(b,0,0),In.splice(b,0,0)}wn("addSeries",b)}function Bh(x,b){b=b??M.length,x=s==1?hu(x,b,up,gp):hu(x,b,{},mp),M.splice(b,0,x),xr(M[b],b)}n.addSeries=Bh;function $a(x){if(M.splice(x,1),tt){pt.values.splice(x,1),Jt.splice(x,1);let b=he.splice(x,1)[0];bt(null,b.firstChild),b.remove()}gt&&(it.splice(x,1),ae.splice(x,1)[0].remove(),ke.splice(x,1),In.splice(x,1)),wn("delSeries",x)}n.delSeries=$a;let Oi=[!1,!1,!1,!1];function ts(x,b){if(x._show=x.show,x.show){let I=x.side%2,U=v[x.scale];U==null&&(x.scale=I?M[1].scale:A,U=v[x.scale]);let X=U.time;x.size=be(x.size),x.space=be(x.space),x.rotate=be(x.rotate),Is(x.incrs)&&x.incrs.forEach(ft=>{!Ls.has(ft)&&Ls.set(ft,Ip(ft))}),x.incrs=be(x.incrs||(U.distr==2?cx:X?f==1?ux:px:Qs)),x.splits=be(x.splits||(X&&U.distr==1?ct:U.distr==3?ou:U.distr==4?Lx:Ix)),x.stroke=be(x.stroke),x.grid.stroke=be(x.grid.stroke),x.ticks.stroke=be(x.ticks.stroke),x.border.stroke=be(x.border.stroke);let J=x.values;x.values=Is(J)&&!Is(J[0])?be(J):X?Is(J)?ap(q,op(J,H)):np(J)?_x(q,J):J||Y:J||Px,x.filter=be(x.filter||(U.distr>=3&&U.log==10?Ux:U.distr==3&&U.log==2?Fx:Rp)),x.font=Mp(x.font),x.labelFont=Mp(x.labelFont),x._size=x.size(n,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Oi[b]=!0,x._el=gi(y_,u))}}function es(x,b,I,U){let[X,J,ft,wt]=I,It=b%2,Vt=0;return It==0&&(wt||J)&&(Vt=b==0&&!X||b==2&&!ft?mn(hp.size/3):0),It==1&&(X||ft)&&(Vt=b==1&&!J||b==3&&!wt?mn(fp.size/2):0),Vt}let Po=n.padding=(i.padding||[es,es,es,es]).map(x=>be(Ae(x,es))),Mi=n._padding=Po.map((x,b)=>x(n,b,Oi,0)),tn,rn=null,on=null,Bi=s==1?M[0].idxs:null,Kn=null,Es=!1;function Io(x,b){if(t=x??[],n.data=n._data=t,s==2){tn=0;for(let I=1;I<M.length;I++)tn+=t[I][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Kn=t[0],tn=Kn.length;let I=t;if(z==2){I=t.slice();let U=I[0]=Array(tn);for(let X=0;X<tn;X++)U[X]=X}n._data=t=I}if(ge(!0),wn("setData"),z==2&&(vt=!0),b!==!1){let I=D;I.auto(n,Es)?Lo():Cs(A,I.min,I.max),et=et||ht.left>=0,St=!0,Ln()}}n.setData=Io;function Lo(){Es=!0;let x,b;s==1&&(tn>0?(rn=Bi[0]=0,on=Bi[1]=tn-1,x=t[0][rn],b=t[0][on],z==2?(x=rn,b=on):x==b&&(z==3?[x,b]=ol(x,x,D.log,!1):z==4?[x,b]=pu(x,x,D.log,!1):D.time?b=x+mn(86400/f):[x,b]=il(x,b,mu,!0))):(rn=Bi[0]=x=null,on=Bi[1]=b=null)),Cs(A,x,b)}let yr,Ts,vr,w,G,nt,$,Z,Dt,Ft;function Nt(x,b,I,U,X,J){x??=zf,I??=_u,U??="butt",X??=zf,J??="round",x!=yr&&(d.strokeStyle=yr=x),X!=Ts&&(d.fillStyle=Ts=X),b!=vr&&(d.lineWidth=vr=b),J!=G&&(d.lineJoin=G=J),U!=nt&&(d.lineCap=nt=U),I!=w&&d.setLineDash(w=I)}function Bt(x,b,I,U){b!=Ts&&(d.fillStyle=Ts=b),x!=$&&(d.font=$=x),I!=Z&&(d.textAlign=Z=I),U!=Dt&&(d.textBaseline=Dt=U)}function Kt(x,b,I,U,X=0){if(U.length>0&&x.auto(n,Es)&&(b==null||b.min==null)){let J=Ae(rn,0),ft=Ae(on,U.length-1),wt=I.min==null?U_(U,J,ft,X,x.distr==3):[I.min,I.max];x.min=Ai(x.min,I.min=wt[0]),x.max=kn(x.max,I.max=wt[1])}}let ue={min:null,max:null};function xe(){for(let U in v){let X=v[U];V[U]==null&&(X.min==null||V[A]!=null&&X.auto(n,Es))&&(V[U]=ue)}for(let U in v){let X=v[U];V[U]==null&&X.from!=null&&V[X.from]!=null&&(V[U]=ue)}V[A]!=null&&ge(!0);let x={};for(let U in V){let X=V[U];if(X!=null){let J=x[U]=Nr(v[U],W_);if(X.min!=null)dn(J,X);else if(U!=A||s==2)if(tn==0&&J.from==null){let ft=J.range(n,null,null,U);J.min=ft[0],J.max=ft[1]}else J.min=Ve,J.max=-Ve}}if(tn>0){M.forEach((U,X)=>{if(s==1){let J=U.scale,ft=V[J];if(ft==null)return;let wt=x[J];if(X==0){let It=wt.range(n,wt.min,wt.max,J);wt.min=It[0],wt.max=It[1],rn=Ti(wt.min,t[0]),on=Ti(wt.max,t[0]),on-rn>1&&(t[0][rn]<wt.min&&rn++,t[0][on]>wt.max&&on--),U.min=Kn[rn],U.max=Kn[on]}else U.show&&U.auto&&Kt(wt,ft,U,t[X],U.sorted);U.idxs[0]=rn,U.idxs[1]=on}else if(X>0&&U.show&&U.auto){let[J,ft]=U.facets,wt=J.scale,It=ft.scale,[Vt,Ht]=t[X],qt=x[wt],pe=x[It];qt!=null&&Kt(qt,V[wt],J,Vt,J.sorted),pe!=null&&Kt(pe,V[It],ft,Ht,ft.sorted),U.min=ft.min,U.max=ft.max}});for(let U in x){let X=x[U],J=V[U];if(X.from==null&&(J==null||J.min==null)){let ft=X.range(n,X.min==Ve?null:X.min,X.max==-Ve?null:X.max,U);X.min=ft[0],X.max=ft[1]}}}for(let U in x){let X=x[U];if(X.from!=null){let J=x[X.from];if(J.min==null)X.min=X.max=null;else{let ft=X.range(n,J.min,J.max,U);X.min=ft[0],X.max=ft[1]}}}let b={},I=!1;for(let U in x){let X=x[U],J=v[U];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let ft=J.distr;J._min=ft==3?rs(J.min):ft==4?Kh(J.min,J.asinh):ft==100?J.fwd(J.min):J.min,J._max=ft==3?rs(J.max):ft==4?Kh(J.max,J.asinh):ft==100?J.fwd(J.max):J.max,b[U]=I=!0}}if(I){M.forEach((U,X)=>{s==2?X>0&&b.y&&(U._paths=null):b[U.scale]&&(U._paths=null)});for(let U in b)vt=!0,wn("setScale",U);gt&&ht.left>=0&&(et=St=!0)}for(let U in V)V[U]=null}function $t(x){let b=ru(rn-1,0,tn-1),I=ru(on+1,0,tn-1);for(;x[b]==null&&b>0;)b--;for(;x[I]==null&&I<tn-1;)I++;return[b,I]}function ye(){if(tn>0){let x=M.some(b=>b._focus)&&Ft!=Ot.alpha;x&&(d.globalAlpha=Ft=Ot.alpha),M.forEach((b,I)=>{if(I>0&&b.show&&(je(I,!1),je(I,!0),b._paths==null)){let U=Ft;Ft!=b.alpha&&(d.globalAlpha=Ft=b.alpha);let X=s==2?[0,t[I][0].length-1]:$t(t[I]);b._paths=b.paths(n,I,X[0],X[1]),Ft!=U&&(d.globalAlpha=Ft=U)}}),M.forEach((b,I)=>{if(I>0&&b.show){let U=Ft;Ft!=b.alpha&&(d.globalAlpha=Ft=b.alpha),b._paths!=null&&Fe(I,!1);{let X=b._paths!=null?b._paths.gaps:null,J=b.points.show(n,I,rn,on,X),ft=b.points.filter(n,I,J,X);(J||ft)&&(b.points._paths=b.points.paths(n,I,rn,on,ft),Fe(I,!0))}Ft!=U&&(d.globalAlpha=Ft=U),wn("drawSeries",I)}}),x&&(d.globalAlpha=Ft=1)}}function je(x,b){let I=b?M[x].points:M[x];I._stroke=I.stroke(n,x),I._fill=I.fill(n,x)}function Fe(x,b){let I=b?M[x].points:M[x],{stroke:U,fill:X,clip:J,flags:ft,_stroke:wt=I._stroke,_fill:It=I._fill,_width:Vt=I.width}=I._paths;Vt=He(Vt*Pe,3);let Ht=null,qt=Vt%2/2;b&&It==null&&(It=Vt>0?"#fff":wt);let pe=I.pxAlign==1&&qt>0;if(pe&&d.translate(qt,qt),!b){let Re=T-Vt/2,Te=y-Vt/2,Se=k+Vt,le=st+Vt;Ht=new Path2D,Ht.rect(Re,Te,Se,le)}b?Wt(wt,Vt,I.dash,I.cap,It,U,X,ft,J):Oe(x,wt,Vt,I.dash,I.cap,It,U,X,ft,Ht,J),pe&&d.translate(-qt,-qt)}function Oe(x,b,I,U,X,J,ft,wt,It,Vt,Ht){let qt=!1;It!=0&&C.forEach((pe,Re)=>{if(pe.series[0]==x){let Te=M[pe.series[1]],Se=t[pe.series[1]],le=(Te._paths||Vo).band;Is(le)&&(le=pe.dir==1?le[0]:le[1]);let ne,Ye=null;Te.show&&le&&O_(Se,rn,on)?(Ye=pe.fill(n,Re)||J,ne=Te._paths.clip):le=null,Wt(b,I,U,X,Ye,ft,wt,It,Vt,Ht,ne,le),qt=!0}}),qt||Wt(b,I,U,X,J,ft,wt,It,Vt,Ht)}let pn=Ur|lu;function Wt(x,b,I,U,X,J,ft,wt,It,Vt,Ht,qt){Nt(x,b,I,U,X),(It||Vt||qt)&&(d.save(),It&&d.clip(It),Vt&&d.clip(Vt)),qt?(wt&pn)==pn?(d.clip(qt),Ht&&d.clip(Ht),Me(X,ft),ln(x,J,b)):wt&lu?(Me(X,ft),d.clip(qt),ln(x,J,b)):wt&Ur&&(d.save(),d.clip(qt),Ht&&d.clip(Ht),Me(X,ft),d.restore(),ln(x,J,b)):(Me(X,ft),ln(x,J,b)),(It||Vt||qt)&&d.restore()}function ln(x,b,I){I>0&&(b instanceof Map?b.forEach((U,X)=>{d.strokeStyle=yr=X,d.stroke(U)}):b!=null&&x&&d.stroke(b))}function Me(x,b){b instanceof Map?b.forEach((I,U)=>{d.fillStyle=Ts=U,d.fill(I)}):b!=null&&x&&d.fill(b)}function ns(x,b,I,U){let X=R[x],J;if(U<=0)J=[0,0];else{let ft=X._space=X.space(n,x,b,I,U),wt=X._incrs=X.incrs(n,x,b,I,U,ft);J=sy(b,I,wt,U,ft)}return X._found=J}function cn(x,b,I,U,X,J,ft,wt,It,Vt){let Ht=ft%2/2;S==1&&d.translate(Ht,Ht),Nt(wt,ft,It,Vt,wt),d.beginPath();let qt,pe,Re,Te,Se=X+(U==0||U==3?-J:J);I==0?(pe=X,Te=Se):(qt=X,Re=Se);for(let le=0;le<x.length;le++)b[le]!=null&&(I==0?qt=Re=x[le]:pe=Te=x[le],d.moveTo(qt,pe),d.lineTo(Re,Te));d.stroke(),S==1&&d.translate(-Ht,-Ht)}function Sr(x){let b=!0;return R.forEach((I,U)=>{if(!I.show)return;let X=v[I.scale];if(X.min==null){I._show&&(b=!1,I._show=!1,ge(!1));return}else I._show||(b=!1,I._show=!0,ge(!1));let J=I.side,ft=J%2,{min:wt,max:It}=X,[Vt,Ht]=ns(U,wt,It,ft==0?P:ut);if(Ht==0)return;let qt=X.distr==2,pe=I._splits=I.splits(n,U,wt,It,Vt,Ht,qt),Re=X.distr==2?pe.map(ne=>Kn[ne]):pe,Te=X.distr==2?Kn[pe[1]]-Kn[pe[0]]:Vt,Se=I._values=I.values(n,I.filter(n,Re,U,Ht,Te),U,Ht,Te);I._rotate=J==2?I.rotate(n,Se,U,Ht):0;let le=I._size;I._size=_i(I.size(n,Se,U,x)),le!=null&&I._size!=le&&(b=!1)}),b}function zi(x){let b=!0;return Po.forEach((I,U)=>{let X=I(n,U,Oi,x);X!=Mi[U]&&(b=!1),Mi[U]=X}),b}function is(){for(let x=0;x<R.length;x++){let b=R[x];if(!b.show||!b._show)continue;let I=b.side,U=I%2,X,J,ft=b.stroke(n,x),wt=I==0||I==3?-1:1,[It,Vt]=b._found;if(b.label!=null){let Bn=b.labelGap*wt,ti=mn((b._lpos+Bn)*Pe);Bt(b.labelFont[0],ft,"center",I==2?"top":Bf),d.save(),U==1?(X=J=0,d.translate(ti,mn(y+st/2)),d.rotate((I==3?-el:el)/2)):(X=mn(T+k/2),J=ti);let Ks=Ap(b.label)?b.label(n,x,It,Vt):b.label;d.fillText(Ks,X,J),d.restore()}if(Vt==0)continue;let Ht=v[b.scale],qt=U==0?k:st,pe=U==0?T:y,Re=b._splits,Te=Ht.distr==2?Re.map(Bn=>Kn[Bn]):Re,Se=Ht.distr==2?Kn[Re[1]]-Kn[Re[0]]:It,le=b.ticks,ne=b.border,Ye=le.show?le.size:0,nn=mn(Ye*Pe),En=mn((b.alignTo==2?b._size-Ye-b.gap:b.gap)*Pe),Ge=b._rotate*-el/180,sn=m(b._pos*Pe),jn=(nn+En)*wt,On=sn+jn;J=U==0?On:0,X=U==1?On:0;let pi=b.font[0],bi=b.align==1?Rr:b.align==2?$h:Ge>0?Rr:Ge<0?$h:U==0?"center":I==3?$h:Rr,Vi=Ge||U==1?"middle":I==2?"top":Bf;Bt(pi,ft,bi,Vi);let Qn=b.font[1]*b.lineGap,mi=Re.map(Bn=>m(a(Bn,Ht,qt,pe))),wi=b._values;for(let Bn=0;Bn<wi.length;Bn++){let ti=wi[Bn];if(ti!=null){U==0?X=mi[Bn]:J=mi[Bn],ti=""+ti;let Ks=ti.indexOf(`
`)==-1?[ti]:ti.split(/\n/gm);for(let zn=0;zn<Ks.length;zn++){let Ff=Ks[zn];Ge?(d.save(),d.translate(X,J+zn*Qn),d.rotate(Ge),d.fillText(Ff,0,0),d.restore()):d.fillText(Ff,X,J+zn*Qn)}}}le.show&&cn(mi,le.filter(n,Te,x,Vt,Se),U,I,sn,nn,He(le.width*Pe,3),le.stroke(n,x),le.dash,le.cap);let Hi=b.grid;Hi.show&&cn(mi,Hi.filter(n,Te,x,Vt,Se),U,U==0?2:1,U==0?y:T,U==0?st:k,He(Hi.width*Pe,3),Hi.stroke(n,x),Hi.dash,Hi.cap),ne.show&&cn([sn],[1],U==0?1:0,U==0?1:2,U==1?y:T,U==1?st:k,He(ne.width*Pe,3),ne.stroke(n,x),ne.dash,ne.cap)}wn("drawAxes")}function ge(x){M.forEach((b,I)=>{I>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(U=>{U.min=null,U.max=null})))})}let en=!1,Fn=!1,Be=[];function hn(){Fn=!1;for(let x=0;x<Be.length;x++)wn(...Be[x]);Be.length=0}function Ln(){en||(K_(xf),en=!0)}function Za(x,b=!1){en=!0,Fn=b,x(n),xf(),b&&Be.length>0&&queueMicrotask(hn)}n.batch=Za;function xf(){if(Q&&(xe(),Q=!1),vt&&(Pt(),vt=!1),mt){if($e(p,Rr,kt),$e(p,"top",Ut),$e(p,Bo,P),$e(p,zo,ut),$e(g,Rr,kt),$e(g,"top",Ut),$e(g,Bo,P),$e(g,zo,ut),$e(u,Bo,_t),$e(u,zo,Yt),h.width=mn(_t*Pe),h.height=mn(Yt*Pe),R.forEach(({_el:x,_show:b,_size:I,_pos:U,side:X})=>{if(x!=null)if(b){let J=X===3||X===0?I:0,ft=X%2==1;$e(x,ft?"left":"top",U-J),$e(x,ft?"width":"height",I),$e(x,ft?"top":"left",ft?Ut:kt),$e(x,ft?"height":"width",ft?ut:P),iu(x,tr)}else ei(x,tr)}),yr=Ts=vr=G=nt=$=Z=Dt=w=null,Ft=1,Uo(!0),kt!=yt||Ut!=Xt||P!=Et||ut!=Gt){ge(!1);let x=P/Et,b=ut/Gt;if(gt&&!et&&ht.left>=0){ht.left*=x,ht.top*=b,Mr&&Wi(Mr,mn(ht.left),0,P,ut),br&&Wi(br,0,mn(ht.top),P,ut);for(let I=0;I<ae.length;I++){let U=ae[I];U!=null&&(ke[I]*=x,In[I]*=b,Wi(U,_i(ke[I]),_i(In[I]),P,ut))}}if(qe.show&&!rt&&qe.left>=0&&qe.width>0){qe.left*=x,qe.width*=x,qe.top*=b,qe.height*=b;for(let I in Wh)$e(Tr,I,qe[I])}yt=kt,Xt=Ut,Et=P,Gt=ut}wn("setSize"),mt=!1}_t>0&&Yt>0&&(d.clearRect(0,0,h.width,h.height),wn("drawClear"),E.forEach(x=>x()),wn("draw")),qe.show&&rt&&(Ja(qe),rt=!1),gt&&et&&(Js(null,!0,!1),et=!1),pt.show&&pt.live&&St&&(Vh(),St=!1),l||(l=!0,n.status=1,wn("ready")),Es=!1,en=!1}n.redraw=(x,b)=>{vt=b||!1,x!==!1?Cs(A,D.min,D.max):Ln()};function zh(x,b){let I=v[x];if(I.from==null){if(tn==0){let U=I.range(n,b.min,b.max,x);b.min=U[0],b.max=U[1]}if(b.min>b.max){let U=b.min;b.min=b.max,b.max=U}if(tn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==A&&I.distr==2&&tn>0&&(b.min=Ti(b.min,t[0]),b.max=Ti(b.max,t[0]),b.min==b.max&&b.max++),V[x]=b,Q=!0,Ln()}}n.setScale=zh;let kh,Gh,Mr,br,yf,vf,wr,Er,Sf,Mf,Xe,Je,As=!1,Rn=ht.drag,Mn=Rn.x,bn=Rn.y;gt&&(ht.x&&(kh=gi(S_,g)),ht.y&&(Gh=gi(M_,g)),D.ori==0?(Mr=kh,br=Gh):(Mr=Gh,br=kh),Xe=ht.left,Je=ht.top);let qe=n.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Tr=qe.show?gi(v_,qe.over?g:p):null;function Ja(x,b){if(qe.show){for(let I in x)qe[I]=x[I],I in Wh&&$e(Tr,I,x[I]);b!==!1&&wn("setSelect")}}n.setSelect=Ja;function t_(x){if(M[x].show)tt&&iu(he[x],tr);else if(tt&&ei(he[x],tr),gt){let I=Ct?ae[0]:ae[x];I!=null&&Wi(I,-10,-10,P,ut)}}function Cs(x,b,I){zh(x,{min:b,max:I})}function ki(x,b,I,U){b.focus!=null&&r_(x),b.show!=null&&M.forEach((X,J)=>{J>0&&(x==J||x==null)&&(X.show=b.show,t_(J),s==2?(Cs(X.facets[0].scale,null,null),Cs(X.facets[1].scale,null,null)):Cs(X.scale,null,null),Ln())}),I!==!1&&wn("setSeries",x,b),U&&Fo("setSeries",n,x,b)}n.setSeries=ki;function e_(x,b){dn(C[x],b)}function n_(x,b){x.fill=be(x.fill||null),x.dir=Ae(x.dir,-1),b=b??C.length,C.splice(b,0,x)}function i_(x){x==null?C.length=0:C.splice(x,1)}n.addBand=n_,n.setBand=e_,n.delBand=i_;function s_(x,b){M[x].alpha=b,gt&&ae[x]!=null&&(ae[x].style.opacity=b),tt&&he[x]&&(he[x].style.opacity=b)}let ss,Rs,Zs,Ar={focus:!0};function r_(x){if(x!=Zs){let b=x==null,I=Ot.alpha!=1;M.forEach((U,X)=>{if(s==1||X>0){let J=b||X==0||X==x;U._focus=b?null:J,I&&s_(X,J?1:Ot.alpha)}}),Zs=x,I&&Ln()}}tt&&te&&xt(Vf,Lt,x=>{ht._lock||(ie(x),Zs!=null&&ki(null,Ar,!0,un.setSeries))});function Gi(x,b,I){let U=v[b];I&&(x=x/Pe-(U.ori==1?Ut:kt));let X=P;U.ori==1&&(X=ut,x=X-x),U.dir==-1&&(x=X-x);let J=U._min,ft=U._max,wt=x/X,It=J+(ft-J)*wt,Vt=U.distr;return Vt==3?Lr(10,It):Vt==4?z_(It,U.asinh):Vt==100?U.bwd(It):It}function o_(x,b){let I=Gi(x,A,b);return Ti(I,t[0],rn,on)}n.valToIdx=x=>Ti(x,t[0]),n.posToIdx=o_,n.posToVal=Gi,n.valToPos=(x,b,I)=>v[b].ori==0?r(x,v[b],I?k:P,I?T:0):o(x,v[b],I?st:ut,I?y:0),n.setCursor=(x,b,I)=>{Xe=x.left,Je=x.top,Js(null,b,I)};function bf(x,b){$e(Tr,Rr,qe.left=x),$e(Tr,Bo,qe.width=b)}function wf(x,b){$e(Tr,"top",qe.top=x),$e(Tr,zo,qe.height=b)}let Do=D.ori==0?bf:wf,No=D.ori==1?bf:wf;function a_(){if(tt&&pt.live)for(let x=s==2?1:0;x<M.length;x++){if(x==0&&fe)continue;let b=pt.values[x],I=0;for(let U in b)Jt[x][I++].firstChild.nodeValue=b[U]}}function Vh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((I,U)=>{it[U]=I}):H_(x.idx)||it.fill(x.idx),pt.idx=it[0]),tt&&pt.live){for(let I=0;I<M.length;I++)(I>0||s==1&&!fe)&&l_(I,it[I]);a_()}St=!1,b!==!1&&wn("setLegend")}n.setLegend=Vh;function l_(x,b){let I=M[x],U=x==0&&z==2?Kn:t[x],X;fe?X=I.values(n,x,b)??re:(X=I.value(n,b==null?null:U[b],x,b),X=X==null?re:{_:X}),pt.values[x]=X}function Js(x,b,I){Sf=Xe,Mf=Je,[Xe,Je]=ht.move(n,Xe,Je),ht.left=Xe,ht.top=Je,gt&&(Mr&&Wi(Mr,mn(Xe),0,P,ut),br&&Wi(br,0,mn(Je),P,ut));let U,X=rn>on;ss=Ve,Rs=null;let J=D.ori==0?P:ut,ft=D.ori==1?P:ut;if(Xe<0||tn==0||X){U=ht.idx=null;for(let wt=0;wt<M.length;wt++){let It=ae[wt];It!=null&&Wi(It,-10,-10,P,ut)}te&&ki(null,Ar,!0,x==null&&un.setSeries),pt.live&&(it.fill(U),St=!0)}else{let wt,It,Vt;s==1&&(wt=D.ori==0?Xe:Je,It=Gi(wt,A),U=ht.idx=Ti(It,t[0],rn,on),Vt=W(t[0][U],D,J,0));let Ht=-10,qt=-10,pe=0,Re=0,Te=!0,Se="",le="";for(let ne=s==2?1:0;ne<M.length;ne++){let Ye=M[ne],nn=it[ne],En=nn==null?null:s==1?t[ne][nn]:t[ne][1][nn],Ge=ht.dataIdx(n,ne,U,It),sn=Ge==null?null:s==1?t[ne][Ge]:t[ne][1][Ge];if(St=St||sn!=En||Ge!=nn,it[ne]=Ge,ne>0&&Ye.show){let jn=Ge==null?-10:Ge==U?Vt:W(s==1?t[0][Ge]:t[ne][0][Ge],D,J,0),On=sn==null?-10:L(sn,s==1?v[Ye.scale]:v[Ye.facets[1].scale],ft,0);if(te&&sn!=null){let pi=D.ori==1?Xe:Je,bi=gn(Ot.dist(n,ne,Ge,On,pi));if(bi<ss){let Vi=Ot.bias;if(Vi!=0){let Qn=Gi(pi,Ye.scale),mi=sn>=0?1:-1,wi=Qn>=0?1:-1;wi==mi&&(wi==1?Vi==1?sn>=Qn:sn<=Qn:Vi==1?sn<=Qn:sn>=Qn)&&(ss=bi,Rs=ne)}else ss=bi,Rs=ne}}if(St||Ct){let pi,bi;D.ori==0?(pi=jn,bi=On):(pi=On,bi=jn);let Vi,Qn,mi,wi,Hi,Bn,ti=!0,Ks=lt.bbox;if(Ks!=null){ti=!1;let zn=Ks(n,ne);mi=zn.left,wi=zn.top,Vi=zn.width,Qn=zn.height}else mi=pi,wi=bi,Vi=Qn=lt.size(n,ne);if(Bn=lt.fill(n,ne),Hi=lt.stroke(n,ne),Ct)ne==Rs&&ss<=Ot.prox&&(Ht=mi,qt=wi,pe=Vi,Re=Qn,Te=ti,Se=Bn,le=Hi);else{let zn=ae[ne];zn!=null&&(ke[ne]=mi,In[ne]=wi,Zf(zn,Vi,Qn,ti),Yf(zn,Bn,Hi),Wi(zn,_i(mi),_i(wi),P,ut))}}}}if(Ct){let ne=Ot.prox,Ye=Zs==null?ss<=ne:ss>ne||Rs!=Zs;if(St||Ye){let nn=ae[0];nn!=null&&(ke[0]=Ht,In[0]=qt,Zf(nn,pe,Re,Te),Yf(nn,Se,le),Wi(nn,_i(Ht),_i(qt),P,ut))}}}if(qe.show&&As)if(x!=null){let[wt,It]=un.scales,[Vt,Ht]=un.match,[qt,pe]=x.cursor.sync.scales,Re=x.cursor.drag;if(Mn=Re._x,bn=Re._y,Mn||bn){let{left:Te,top:Se,width:le,height:ne}=x.select,Ye=x.scales[qt].ori,nn=x.posToVal,En,Ge,sn,jn,On,pi=wt!=null&&Vt(wt,qt),bi=It!=null&&Ht(It,pe);pi&&Mn?(Ye==0?(En=Te,Ge=le):(En=Se,Ge=ne),sn=v[wt],jn=W(nn(En,qt),sn,J,0),On=W(nn(En+Ge,qt),sn,J,0),Do(Ai(jn,On),gn(On-jn))):Do(0,J),bi&&bn?(Ye==1?(En=Te,Ge=le):(En=Se,Ge=ne),sn=v[It],jn=L(nn(En,pe),sn,ft,0),On=L(nn(En+Ge,pe),sn,ft,0),No(Ai(jn,On),gn(On-jn))):No(0,ft)}else Xh()}else{let wt=gn(Sf-yf),It=gn(Mf-vf);if(D.ori==1){let pe=wt;wt=It,It=pe}Mn=Rn.x&&wt>=Rn.dist,bn=Rn.y&&It>=Rn.dist;let Vt=Rn.uni;Vt!=null?Mn&&bn&&(Mn=wt>=Vt,bn=It>=Vt,!Mn&&!bn&&(It>wt?bn=!0:Mn=!0)):Rn.x&&Rn.y&&(Mn||bn)&&(Mn=bn=!0);let Ht,qt;Mn&&(D.ori==0?(Ht=wr,qt=Xe):(Ht=Er,qt=Je),Do(Ai(Ht,qt),gn(qt-Ht)),bn||No(0,ft)),bn&&(D.ori==1?(Ht=wr,qt=Xe):(Ht=Er,qt=Je),No(Ai(Ht,qt),gn(qt-Ht)),Mn||Do(0,J)),!Mn&&!bn&&(Do(0,0),No(0,0))}if(Rn._x=Mn,Rn._y=bn,x==null){if(I){if(Uf!=null){let[wt,It]=un.scales;un.values[0]=wt!=null?Gi(D.ori==0?Xe:Je,wt):null,un.values[1]=It!=null?Gi(D.ori==1?Xe:Je,It):null}Fo(Zh,n,Xe,Je,P,ut,U)}if(te){let wt=I&&un.setSeries,It=Ot.prox;Zs==null?ss<=It&&ki(Rs,Ar,!0,wt):ss>It?ki(null,Ar,!0,wt):Rs!=Zs&&ki(Rs,Ar,!0,wt)}}St&&(pt.idx=U,Vh()),b!==!1&&wn("setCursor")}let Ps=null;Object.defineProperty(n,"rect",{get(){return Ps==null&&Uo(!1),Ps}});function Uo(x=!1){x?Ps=null:(Ps=g.getBoundingClientRect(),wn("syncRect",Ps))}function Ef(x,b,I,U,X,J,ft){ht._lock||As&&x!=null&&x.movementX==0&&x.movementY==0||(Hh(x,b,I,U,X,J,ft,!1,x!=null),x!=null?Js(null,!0,!0):Js(b,!0,!1))}function Hh(x,b,I,U,X,J,ft,wt,It){if(Ps==null&&Uo(!1),ie(x),x!=null)I=x.clientX-Ps.left,U=x.clientY-Ps.top;else{if(I<0||U<0){Xe=-10,Je=-10;return}let[Vt,Ht]=un.scales,qt=b.cursor.sync,[pe,Re]=qt.values,[Te,Se]=qt.scales,[le,ne]=un.match,Ye=b.axes[0].side%2==1,nn=D.ori==0?P:ut,En=D.ori==1?P:ut,Ge=Ye?J:X,sn=Ye?X:J,jn=Ye?U:I,On=Ye?I:U;if(Te!=null?I=le(Vt,Te)?a(pe,v[Vt],nn,0):-10:I=nn*(jn/Ge),Se!=null?U=ne(Ht,Se)?a(Re,v[Ht],En,0):-10:U=En*(On/sn),D.ori==1){let pi=I;I=U,U=pi}}It&&(b==null||b.cursor.event.type==Zh)&&((I<=1||I>=P-1)&&(I=js(I,P)),(U<=1||U>=ut-1)&&(U=js(U,ut))),wt?(yf=I,vf=U,[wr,Er]=ht.move(n,I,U)):(Xe=I,Je=U)}let Wh={width:0,height:0,left:0,top:0};function Xh(){Ja(Wh,!1)}let Tf,Af,Cf,Rf;function Pf(x,b,I,U,X,J,ft){As=!0,Mn=bn=Rn._x=Rn._y=!1,Hh(x,b,I,U,X,J,ft,!0,!1),x!=null&&(xt(Jh,eu,If,!1),Fo(kf,n,wr,Er,P,ut,null));let{left:wt,top:It,width:Vt,height:Ht}=qe;Tf=wt,Af=It,Cf=Vt,Rf=Ht}function If(x,b,I,U,X,J,ft){As=Rn._x=Rn._y=!1,Hh(x,b,I,U,X,J,ft,!1,!0);let{left:wt,top:It,width:Vt,height:Ht}=qe,qt=Vt>0||Ht>0,pe=Tf!=wt||Af!=It||Cf!=Vt||Rf!=Ht;if(qt&&pe&&Ja(qe),Rn.setScale&&qt&&pe){let Re=wt,Te=Vt,Se=It,le=Ht;if(D.ori==1&&(Re=It,Te=Ht,Se=wt,le=Vt),Mn&&Cs(A,Gi(Re,A),Gi(Re+Te,A)),bn)for(let ne in v){let Ye=v[ne];ne!=A&&Ye.from==null&&Ye.min!=Ve&&Cs(ne,Gi(Se+le,ne),Gi(Se,ne))}Xh()}else ht.lock&&(ht._lock=!ht._lock,Js(b,!0,x!=null));x!=null&&(bt(Jh,eu),Fo(Jh,n,Xe,Je,P,ut,null))}function c_(x,b,I,U,X,J,ft){if(ht._lock)return;ie(x);let wt=As;if(As){let It=!0,Vt=!0,Ht=10,qt,pe;D.ori==0?(qt=Mn,pe=bn):(qt=bn,pe=Mn),qt&&pe&&(It=Xe<=Ht||Xe>=P-Ht,Vt=Je<=Ht||Je>=ut-Ht),qt&&It&&(Xe=Xe<wr?0:P),pe&&Vt&&(Je=Je<Er?0:ut),Js(null,!0,!0),As=!1}Xe=-10,Je=-10,it.fill(null),Js(null,!0,!0),wt&&(As=wt)}function Lf(x,b,I,U,X,J,ft){ht._lock||(ie(x),Lo(),Xh(),x!=null&&Fo(Hf,n,Xe,Je,P,ut,null))}function Df(){R.forEach(ry),F(n.width,n.height,!0)}er(nl,Ir,Df);let Cr={};Cr.mousedown=Pf,Cr.mousemove=Ef,Cr.mouseup=If,Cr.dblclick=Lf,Cr.setSeries=(x,b,I,U)=>{let X=un.match[2];I=X(n,b,I),I!=-1&&ki(I,U,!0,!1)},gt&&(xt(kf,g,Pf),xt(Zh,g,Ef),xt(Gf,g,x=>{ie(x),Uo(!1)}),xt(Vf,g,c_),xt(Hf,g,Lf),cu.add(n),n.syncRect=Uo);let Ka=n.hooks=i.hooks||{};function wn(x,b,I){Fn?Be.push([x,b,I]):x in Ka&&Ka[x].forEach(U=>{U.call(null,n,b,I)})}(i.plugins||[]).forEach(x=>{for(let b in x.hooks)Ka[b]=(Ka[b]||[]).concat(x.hooks[b])});let Nf=(x,b,I)=>I,un=dn({key:null,setSeries:!1,filters:{pub:tp,sub:tp},scales:[A,M[1]?M[1].scale:null],match:[ep,ep,Nf],values:[null,null]},ht.sync);un.match.length==2&&un.match.push(Nf),ht.sync=un;let Uf=un.key,qh=Kp(Uf);function Fo(x,b,I,U,X,J,ft){un.filters.pub(x,b,I,U,X,J,ft)&&qh.pub(x,b,I,U,X,J,ft)}qh.sub(n);function h_(x,b,I,U,X,J,ft){un.filters.sub(x,b,I,U,X,J,ft)&&Cr[x](null,b,I,U,X,J,ft)}n.pub=h_;function u_(){qh.unsub(n),cu.delete(n),dt.clear(),su(nl,Ir,Df),c.remove(),Lt?.remove(),wn("destroy")}n.destroy=u_;function Yh(){wn("init",i,t),Io(t||i.data,!1),V[A]?zh(A,V[A]):Lo(),rt=qe.show&&(qe.width>0||qe.height>0),et=St=!0,F(i.width,i.height)}return M.forEach(xr),R.forEach(ts),e?e instanceof HTMLElement?(e.appendChild(c),Yh()):e(n,Yh):Yh(),n}_n.assign=dn;_n.fmtNum=gu;_n.rangeNum=il;_n.rangeLog=ol;_n.rangeAsinh=pu;_n.orient=ir;_n.pxRatio=Pe;_n.join=J_;_n.fmtDate=xu,_n.tzDate=ax;_n.sync=Kp;{_n.addGap=Hx,_n.clipGaps=cl;let i=_n.paths={points:im};i.linear=rm,i.stepped=qx,i.bars=Yx,i.spline=Zx}function Xi(i,t){if(!Number.isFinite(i))return"\u2013";let e=Number(i.toPrecision(t)),n=Math.abs(e);return n!==0&&(n>=1e6||n<1e-4)?cm(e.toExponential()):`${e}`}function cm(i){return i.replace("e+","e")}function hm(i,t){let e=Math.max(...i.map(Math.abs));if(e>=1e6||t<1e-4){let r=Math.max(Math.ceil(Math.log10(e/t)-1e-9),0);return i.map(o=>o===0?"0":cm(o.toExponential(Math.min(r,15)).replace(/\.?0+e/,"e")))}let n=0;for(;Math.abs(t*10**n-Math.round(t*10**n))>1e-6;)++n;let s={minimumFractionDigits:n,maximumFractionDigits:n};return i.map(r=>(r===0?0:r).toLocaleString("en-US",s))}function zr(i){let t=10**Math.floor(Math.log10(i));return([1,2,5].find(e=>e*t>=i*(1-1e-9))??10)*t}function fl(i,t,e){let s=new Map;for(let r of i){let o=Math.floor(400*(r.time-t)/(e-t||1));(s.get(o)?.kind??"tick")==="tick"&&s.set(o,r)}return[...s.values()]}var Wo=["#2563eb","#dc2626","#16a34a","#d97706","#7c3aed","#0891b2","#db2777","#65a30d"],pl=600;function Xo(i){let t=getComputedStyle(document.documentElement),e=t.getPropertyValue("--ink-soft").trim(),n={stroke:t.getPropertyValue("--line").trim(),width:1};return{label:i,stroke:e,grid:n,ticks:n,labelSize:18,font:"11px system-ui",labelFont:"11px system-ui",values:(s,r,o,a,l)=>hm(r,l)}}function ml(i){let t=(e,n)=>Math.max(64,36+6.5*Math.max(0,...(n??[]).map(s=>s.length)));return{...Xo(i),size:t}}var oy=20,gl=class{constructor(t,e,n){this.head=t;this.motion=e;let s=t.columns.slice(0,t.scene.first),r=s.filter(c=>c.kind==="coordinate").length,o=r>0?1:Math.min(1,s.length-1),a=r>0?1+r:s.length-1;if(this.choices=[this.choice("right",s,o),this.choice("up",s,a)],this.dot.className="dot",s.length<2)return;let l=document.createElement("p");l.className="portrait",l.append(this.choices[1]," over ",this.choices[0]),n.append(l,this.board),this.rebuild()}head;motion;plot=null;board=document.createElement("div");dot=document.createElement("i");choices;choice(t,e,n){let s=document.createElement("select");return s.setAttribute("aria-label",`Column of the portrait, to the ${t}`.replace("to the up","upward")),e.forEach(({name:r},o)=>s.append(new Option(r,`${o}`,o===n,o===n))),s.onchange=()=>this.rebuild(),s}values(t){let e=Number(this.choices[t].value),{scale:n,shift:s}=this.head.columns[e].display;return this.motion.column(e).map(r=>r*n+s)}get data(){return[null,[this.values(0),this.values(1)]]}rebuild(){this.plot?.destroy();let[t,e]=this.choices.map(s=>{let{name:r,display:o}=this.head.columns[Number(s.value)],a=`[${o.unit||"1"}]`;return r.length<=oy?`${r} ${a}`:a}),n=s=>()=>{let[r,o]=[1/0,-1/0];for(let c of this.values(s))Number.isFinite(c)&&([r,o]=[Math.min(r,c),Math.max(o,c)]);o>r||([r,o]=[(Number.isFinite(r)?r:0)-1,(Number.isFinite(o)?o:0)+1]);let a=Math.max(Math.abs(r),Math.abs(o)),l=Math.max(.06*(o-r),o-r<1e-6*a?.001*a:0,1e-12);return[r-l,o+l]};this.plot=new _n({...this.size(),mode:2,scales:{x:{time:!1,range:n(0)},y:{range:n(1)}},axes:[{...Xo(t),size:40},ml(e)],cursor:{show:!1},legend:{show:!1},series:[{},{facets:[{scale:"x",auto:!0},{scale:"y",auto:!0}],paths:ay}]},this.data,this.board),this.plot.over.append(this.dot)}show(t){this.motion=t,this.plot?.setData(this.data)}point(t){if(this.plot===null||this.motion.count===0||this.board.clientWidth===0)return;let e=this.motion.rowAt(t),[n,s]=this.choices.map(r=>{let o=Number(r.value),{scale:a,shift:l}=this.head.columns[o].display;return this.motion.at(e,o)*a+l});this.dot.style.left=`${this.plot.valToPos(n,"x")}px`,this.dot.style.top=`${this.plot.valToPos(s,"y")}px`}size(){return{width:Math.max(this.board.clientWidth||pl,240),height:240}}resize(){this.plot?.setSize(this.size())}};function ay(i){let[t,e]=i.data[1],{ctx:n}=i;return n.save(),n.beginPath(),n.rect(i.bbox.left,i.bbox.top,i.bbox.width,i.bbox.height),n.clip(),n.beginPath(),t.forEach((s,r)=>n.lineTo(i.valToPos(s,"x",!0),i.valToPos(e[r],"y",!0))),n.strokeStyle=Wo[0],n.lineWidth=1.5*window.devicePixelRatio,n.stroke(),n.restore(),null}var um=4,_l=class{constructor(t,e,n,s){this.head=t;this.sought=s;this.motion=e,this.events=t.events;let r=this.columns(),o=r.filter(({column:c})=>c.kind==="coordinate").slice(0,um);this.chosen=new Set((o.length>0?o:r.slice(0,um)).map(({index:c})=>c));let a=document.createElement("details"),l=document.createElement("summary");l.textContent="Choose curves",a.append(l,...r.map(({column:c,index:h})=>this.choice(c,h))),this.board=document.createElement("div"),n.append(a,this.board),this.portrait=new gl(t,e,n),new ResizeObserver(([{contentRect:c}])=>{this.seen=c.width>0,this.resize()}).observe(n),window.addEventListener("beforeprint",()=>{this.seen=!0,this.point(this.time)}),this.rebuild()}head;sought;charts=[];chosen;board;portrait;motion;events;family=[];time=0;seen=!1;columns(){return this.head.columns.map((t,e)=>({column:t,index:e})).slice(1,this.head.scene.first)}choice(t,e){let n=document.createElement("label");n.className="choice";let s=document.createElement("input");return s.type="checkbox",s.checked=this.chosen.has(e),s.onchange=()=>{s.checked?this.chosen.add(e):this.chosen.delete(e),this.rebuild()},n.append(s,`${t.name}${t.display.unit?` [${t.display.unit}]`:""}`),n.title=t.doc??"",n}rebuild(){for(let s of this.charts)s.plot.destroy();this.charts.length=0;let t=new Map;for(let s of[...this.chosen].sort((r,o)=>r-o)){let r=this.head.columns[s].display.unit;t.set(r,[...t.get(r)??[],s])}for(let[s,r]of t)this.overTime(s,r);let e=this.head.scene.first+this.head.scene.count,n={name:"energy",display:{unit:"J",scale:1,shift:0}};this.add("J",[n.name],s=>[s.column(0),s.column(e)]),this.point(this.time)}value(t,e){let{scale:n,shift:s}=this.head.columns[e].display;return t.column(e).map(r=>r*n+s)}overTime(t,e){let n=e.map(r=>this.head.columns[r].name),s=r=>e.map(o=>this.value(r,o));this.add(t,n,r=>[r.column(0),...s(r)])}underlay(t,e){let{ctx:n,bbox:s}=t;n.save(),n.beginPath(),n.rect(s.left,s.top,s.width,s.height),n.clip(),n.lineWidth=window.devicePixelRatio,n.strokeStyle="rgb(148 163 184 / 45%)";for(let r of this.family){let[o,...a]=e(r);for(let l of a)n.beginPath(),o.forEach((c,h)=>n.lineTo(t.valToPos(c,"x",!0),t.valToPos(l[h],"y",!0))),n.stroke()}n.strokeStyle="#dc2626";for(let{time:r,kind:o}of fl(this.events,t.scales.x.min??0,t.scales.x.max??1)){let a=t.valToPos(r,"x",!0);n.globalAlpha=o==="tick"?.25:1,n.beginPath(),n.moveTo(a,s.top+s.height),n.lineTo(a,s.top+s.height-7*window.devicePixelRatio),n.stroke()}n.restore()}range(t,e,n){let[s,r]=[e??0,n??1];for(let l of this.family)for(let c of t(l).slice(1))for(let h of c)Number.isFinite(h)&&([s,r]=[Math.min(s,h),Math.max(r,h)]);let o=Math.max(Math.abs(s),Math.abs(r)),a=Math.max(.06*(r-s),r-s<1e-6*o?.001*o:0,1e-12);return[s-a,r+a]}add(t,e,n){let s=new _n({...this.size(),scales:{x:{time:!1},y:{range:(r,o,a)=>this.range(n,o,a)}},axes:[{...Xo("t [s]"),size:40},ml(t===""?"":`[${t}]`)],cursor:{sync:{key:"time"},drag:{x:!1,y:!1}},series:[{label:"t",value:(r,o)=>dm(o,"s")},...e.map((r,o)=>({label:r,stroke:Wo[o%Wo.length],width:1.5,value:(a,l)=>dm(l,t)}))],hooks:{ready:[r=>r.over.addEventListener("click",()=>this.seek(r))],drawAxes:[r=>this.underlay(r,n)]}},n(this.motion),this.board);this.charts.push({plot:s,data:n})}seek(t){t.cursor.left!==void 0&&t.cursor.left>=0&&this.sought(t.posToVal(t.cursor.left,"x"))}show(t,e=[]){this.motion=t,this.events=e;for(let{plot:n,data:s}of this.charts)n.setData(s(t));this.portrait.show(t)}behind(t){this.family=t,this.rebuild()}point(t){if(this.time=t,!!this.seen){for(let{plot:e}of this.charts)e.setCursor({left:e.valToPos(t,"x"),top:-10},!1);this.portrait.point(t)}}size(){return{width:Math.max(this.board.clientWidth||pl,240),height:190}}resize(){for(let{plot:t}of this.charts)t.setSize(this.size());this.portrait.resize(),queueMicrotask(()=>this.point(this.time))}};function dm(i,t){return i===null||!Number.isFinite(i)?"\u2013":`${Xi(i,5)} ${t}`}function kr(i,t){let e=document.createElement("a");e.href=URL.createObjectURL(i),e.download=t,e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e3)}function fm(i,t){i.toBlob(e=>e!==null&&kr(e,`${t.name}.png`),"image/png")}function pm(i,t){let e=t.columns.slice(0,t.scene.first),n=r=>/[",\n]/.test(r)?`"${r.replaceAll('"','""')}"`:r,s=[e.map(r=>n(r.name)).join(",")];for(let r=0;r<i.count;++r)s.push(e.map((o,a)=>i.at(r,a)).join(","));kr(new Blob([`${s.join(`
`)}
`],{type:"text/csv"}),`${t.name}.csv`)}function mm(i,t){let e=[],n=new MediaRecorder(i.captureStream(60),{mimeType:"video/webm"});return n.ondataavailable=s=>e.push(s.data),n.onstop=()=>kr(new Blob(e,{type:"video/webm"}),`${t.name}.webm`),n.start(),()=>n.stop()}var Eu=class{list=[];put(...t){for(let e of t)this.list.push(e)}word(t){this.put(t&255,t>>8)}text(t){for(let e of t)this.put(e.charCodeAt(0))}get all(){return Uint8Array.from(this.list)}};function ly(i,t,e){return(Math.round(i*5/255)*7+Math.round(t*6/255))*6+Math.round(e*5/255)}function cy(i,t){let[e,n]=[256,257],s=new Map,[r,o,a,l]=[258,9,0,0],c=[],h=()=>{c.length>0&&t.put(c.length,...c),c=[]},d=p=>{for(a|=p<<l,l+=o;l>=8;)c.push(a&255),a>>=8,l-=8,c.length===255&&h()};t.put(8),d(e);let u=i[0];for(let p=1;p<i.length;++p){let g=u<<8|i[p],S=s.get(g);if(S!==void 0){u=S;continue}d(u),r<4096?(r===1<<o&&o<12&&++o,s.set(g,r++)):(d(e),s=new Map,[r,o]=[258,9]),u=i[p]}d(u),r===1<<o&&o<12&&++o,d(n),l>0&&c.push(a&255),h(),t.put(0)}function gm(i,t){let e=new Eu,{width:n,height:s}=i[0];e.text("GIF89a"),e.word(n),e.word(s),e.put(247,0,0);for(let r=0;r<256;++r){let[o,a,l]=[Math.floor(r/42),Math.floor(r/6)%7,r%6];e.put(Math.min(o*51,255),Math.min(Math.round(a*42.5),255),l*51)}e.put(33,255,11),e.text("NETSCAPE2.0"),e.put(3,1,0,0,0);for(let{data:r}of i){e.put(33,249,4,0),e.word(Math.round(t/10)),e.put(0,0,44,0,0,0,0),e.word(n),e.word(s),e.put(0);let o=new Uint8Array(n*s);for(let a=0;a<o.length;++a)o[a]=ly(r[4*a],r[4*a+1],r[4*a+2]);cy(o,e)}return e.put(59),new Blob([e.all],{type:"image/gif"})}function _m(i){return document.getElementById(i)?.textContent??""}function xm(){return JSON.parse(_m("head"))}function hy(i){let t=atob(i.trim()),e=new Uint8Array(t.length);for(let n=0;n<t.length;++n)e[n]=t.charCodeAt(n);return e}async function Tu(i){let t=new Blob([hy(i)]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function Gr(i){return Tu(_m(i))}var Vr=class{constructor(t,e){this.width=t;this.values=e;this.count=Math.floor(e.length/t)}width;values;count;at(t,e){return this.values[t*this.width+e]}get last(){return this.count>0?this.at(this.count-1,0):0}rowAt(t){let e=0,n=this.count-1;for(;e<n;){let s=e+n+1>>1;this.at(s,0)<=t?e=s:n=s-1}return e}state(t,e){let n=this.rowAt(t),s=Math.min(n+1,this.count-1),r=this.at(s,0)-this.at(n,0),o=r>0?Math.min(Math.max((t-this.at(n,0))/r,0),1):0;for(let a=0;a<this.width;++a){let l=this.at(n,a);e[a]=l+o*(this.at(s,a)-l)}return e}largest(t){let e=0;for(let n=0;n<this.count;++n){let s=Math.abs(this.at(n,t));Number.isFinite(s)&&(e=Math.max(e,s))}return e}column(t){return Float64Array.from({length:this.count},(e,n)=>this.at(n,t))}};function ym(i,t){let e=new Float32Array(t.buffer),n=i.runs?.map(o=>o.rows)??[i.rows],s=e.length/n.reduce((o,a)=>o+a,0),r=0;return n.map(o=>{let a=new Float32Array(o*s);for(let l=0;l<s;++l)for(let c=0;c<o;++c)a[c*s+l]=e[r+l*o+c];return r+=o*s,new Vr(s,a)})}function Au(i){if(i.length===1)return i[0];let t=new Float32Array(i.reduce((n,s)=>n+s.values.length,0)),e=0;for(let n of i)t.set(n.values,e),e+=n.values.length;return new Vr(i[0].width,t)}var sr=class i{constructor(t,e,n){this.worker=t;this.width=e;this.told=n;t.onmessage=s=>this.arrived(s.data)}worker;width;told;busy=!1;waiting=null;number=0;static async begin(t,e,n,{tape:s="tape",by:r=[]}={}){if(t.live===!1||typeof WebAssembly>"u"||typeof Worker>"u")return null;try{let o=new Blob([await Gr("worker")],{type:"text/javascript"}),a=new Worker(URL.createObjectURL(o)),l={wasm:(await Gr("wasm")).buffer,tape:(await Gr(s)).buffer,start:t.start,stop:t.stop,rows:e,tolerance:t.tolerance,lasting:t.lasting,by:r},c=await new Promise((h,d)=>{a.onmessage=u=>h(u.data.ready),a.onerror=u=>d(new Error(u.message)),a.postMessage(l,[l.wasm,l.tape])});return new i(a,c,n)}catch{return null}}run(t,e){this.waiting={parameters:t,inputs:e},this.busy||this.next()}next(){this.waiting!==null&&(this.worker.postMessage({number:++this.number,...this.waiting}),this.waiting=null,this.busy=!0)}arrived(t){this.busy=!1;let e=new Vr(this.width,t.rows);this.told({motion:e,status:t.status,time:t.time,took:t.took,derivatives:t.derivatives}),this.next()}};var dy=300,fy=12,py=1e-9,my=["coordinate","rate","state","output"],gy="The motion takes long: nothing is told of its end.",vm="The motion ends before its time: its end moves, too.";function _y(i,t){let{angle:e,group:n,display:s}=i,r=e&&n==="start";return t!==0&&!r?{si:.01*Math.abs(t),words:"1 %",ranked:!0}:{si:1/s.scale,words:`1 ${s.unit}`.trim(),ranked:r}}var xl=class{constructor(t,e){this.head=t;if(this.quantities=[...t.parameters,...t.inputs].filter((o,a)=>{let l=o.kind==="Real";return l&&this.by.push(a),l}),this.by.length===0||t.live===!1||t.modes!==void 0)return;let n=document.createElement("summary");n.textContent="What moves the end most",this.chooser.ariaLabel="The curve whose end moves",t.columns.slice(0,t.scene.first).forEach((o,a)=>{my.includes(o.kind)&&this.chooser.append(new Option(o.name,`${a}`))}),this.chooser.onchange=()=>this.show();let s=document.createElement("table");s.className="influence",s.append(this.rows),this.board.className="influences",this.board.open=!0,this.board.ontoggle=()=>this.ask();let r=document.createElement("div");r.append(this.chooser,this.told),this.board.append(n,r,s),e.append(this.board),t.differentiable||this.say("Delayed values have no derivatives yet.",!0)}head;by=[];quantities;board=document.createElement("details");chooser=document.createElement("select");told=document.createElement("p");rows=document.createElement("tbody");live=null;values=[];wish=null;timer=0;outcome=null;rest(t,e){!this.board.isConnected||!this.head.differentiable||(this.wish={parameters:t,inputs:e},this.board.ariaBusy="true",clearTimeout(this.timer),this.timer=setTimeout(()=>this.ask(),dy))}ask(){if(this.wish===null||!this.board.open)return;let{parameters:t,inputs:e}=this.wish;this.wish=null;let n=[...t,...e];this.values=this.by.map(s=>n[s]),this.live??=sr.begin(this.head,2,s=>this.arrived(s),{by:this.by}),this.live.then(s=>s?.run(t,e))}arrived(t){this.wish===null&&(this.board.ariaBusy="false",this.outcome=t,this.show(),document.documentElement.dataset.influence=t.took.toFixed(2))}say(t,e=!1){this.told.textContent=t,this.chooser.hidden=e}show(){if(this.outcome===null)return;let{status:t,derivatives:e,motion:n,time:s}=this.outcome;if(this.rows.replaceChildren(),e.length===0){let f=t===9?vm:this.head.words[t]??vm;this.say(`${t===-1?gy:f} (t = ${s.toPrecision(5)} s)`,!0);return}let r=Number(this.chooser.value),o=this.head.columns[r],{scale:a,shift:l,unit:c}=o.display,d=`is ${`${Xi(n.at(n.count-1,r)*a+l,4)} ${c}`.trim()} at ${Xi(s,4)} s`;this.say(`${d} and changes with`);let u=this.quantities.map((f,M)=>{let{si:R,words:v,ranked:C}=_y(f,this.values[M]);return{name:f.name,words:v,ranked:C,change:e[M*n.width+r]*R*a}}),p=({change:f})=>Math.abs(f),g=py*Math.max(...u.map(p)),S=u.filter(f=>p(f)>g).sort((f,M)=>p(M)-p(f)),m=S.filter(f=>f.ranked);S.length===0&&this.say(`${d}; no slider moves it.`);for(let f of[...m,...S.filter(M=>!M.ranked)].slice(0,fy))this.row(f,f.ranked?p(f)/p(m[0]):0,c)}row({name:t,words:e,change:n},s,r){let o=document.createElement("tr"),a=document.createElement("th");a.scope="row",a.textContent=t.replace(/\.start$/," at the start");let l=document.createElement("td");l.textContent=e;let c=document.createElement("td");c.className="bar";let h=document.createElement("i");h.style.width=`${100*s}%`,h.className=n<0?"less":"more",s>0&&c.append(h);let d=document.createElement("td");d.textContent=`${n>0?"+":"\u2212"}${Xi(Math.abs(n),3)} ${r}`.trim(),o.append(a,l,c,d),this.rows.append(o)}};var Ws={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Xs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},eg=0,rd=1,ng=2;var Aa=1,ig=2,Mo=3,qs=0,qn=1,Yn=2,dr=0,bo=1,od=2,ad=3,ld=4,sg=5;var fr=100,rg=101,og=102,ag=103,lg=104,cg=200,hg=201,ug=202,dg=203,cd=204,hd=205,fg=206,pg=207,mg=208,gg=209,_g=210,xg=211,yg=212,vg=213,Sg=214,ql=0,Yl=1,$l=2,ao=3,Zl=4,Jl=5,Kl=6,jl=7,Ec=0,Mg=1,bg=2,Ki=0,ud=1,dd=2,fd=3,pd=4,md=5,gd=6,_d=7;var xd=300,pr=301,wo=302,Tc=303,Ac=304,Ql=1e3,Yi=1001,tc=1002,Cn=1003,wg=1004;var Ca=1005;var Wn=1006,Cc=1007;var ys=1008;var Zn=1009,yd=1010,vd=1011,Eo=1012,Rc=1013,Di=1014,Ni=1015,Ui=1016,Pc=1017,Ic=1018,mr=1020,Sd=35902,Md=35899,bd=1021,wd=1022,Fi=1023,ps=1026,vs=1027,Ed=1028,Lc=1029,Ys=1030,Dc=1031;var Nc=1033,Ra=33776,Pa=33777,Ia=33778,La=33779,Uc=35840,Fc=35841,Oc=35842,Bc=35843,zc=36196,kc=37492,Gc=37496,Vc=37488,Hc=37489,Da=37490,Wc=37491,Xc=37808,qc=37809,Yc=37810,$c=37811,Zc=37812,Jc=37813,Kc=37814,jc=37815,Qc=37816,th=37817,eh=37818,nh=37819,ih=37820,sh=37821,rh=36492,oh=36494,ah=36495,lh=36283,ch=36284,Na=36285,hh=36286;var ia=2300,ec=2301,Wl=2302,Ku=2303,ju=2400,Qu=2401,td=2402;var Eg=3200;var uh=0,Tg=1,Ss="",Vn="srgb",sa="srgb-linear",ra="linear",Ne="srgb";var Xl=7680;var Ag=519,Cg=512,Rg=513,Pg=514,Td=515,Ig=516,Lg=517,Ad=518,Cd=519,Rd=35044;var Pd="300 es",yi=2e3,lo=2001;function xy(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function yy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function oa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Dg(){let i=oa("canvas");return i.style.display="block",i}var Sm={},co=null;function aa(...i){let t="THREE."+i.shift();co?co("log",t,...i):console.log(t,...i)}function Ng(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function se(...i){i=Ng(i);let t="THREE."+i.shift();if(co)co("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ce(...i){i=Ng(i);let t="THREE."+i.shift();if(co)co("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ta(...i){let t=i.join(" ");t in Sm||(Sm[t]=!0,se(...i))}function Ug(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Fg={[ql]:ql,[$l]:Kl,[Zl]:Zl,[ao]:Jl,[Yl]:Yl,[Kl]:$l,[jl]:jl,[Jl]:ao},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Dn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Mm=1234567,ea=Math.PI/180,ho=180/Math.PI;function $s(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Dn[i&255]+Dn[i>>8&255]+Dn[i>>16&255]+Dn[i>>24&255]+"-"+Dn[t&255]+Dn[t>>8&255]+"-"+Dn[t>>16&15|64]+Dn[t>>24&255]+"-"+Dn[e&63|128]+Dn[e>>8&255]+"-"+Dn[e>>16&255]+Dn[e>>24&255]+Dn[n&255]+Dn[n>>8&255]+Dn[n>>16&255]+Dn[n>>24&255]).toLowerCase()}function ve(i,t,e){return Math.max(t,Math.min(e,i))}function Id(i,t){return(i%t+t)%t}function vy(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Sy(i,t,e){return i!==t?(e-i)/(t-i):0}function na(i,t,e){return(1-e)*i+e*t}function My(i,t,e,n){return na(i,t,1-Math.exp(-e*n))}function by(i,t=1){return t-Math.abs(Id(i,t*2)-t)}function wy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Ey(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Ty(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Ay(i,t){return i+Math.random()*(t-i)}function Cy(i){return i*(.5-Math.random())}function Ry(i){i!==void 0&&(Mm=i);let t=Mm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Py(i){return i*ea}function Iy(i){return i*ho}function Ly(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Dy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Ld(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Ny(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),d=r((t-n)/2),u=o((t-n)/2),p=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*d,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*d,a*c);break;case"ZXZ":i.set(l*d,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*p,a*c);break;case"YXY":i.set(l*p,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*p,a*h,a*c);break;default:se("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function dh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Dd(i,t){if(t.constructor===Float32Array)return i;let e=dh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Nd(i,t){if(t.constructor===Float32Array)return i;let e=dh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var fh={DEG2RAD:ea,RAD2DEG:ho,generateUUID:$s,clamp:ve,euclideanModulo:Id,mapLinear:vy,inverseLerp:Sy,lerp:na,damp:My,pingpong:by,smoothstep:wy,smootherstep:Ey,randInt:Ty,randFloat:Ay,randFloatSpread:Cy,seededRandom:Ry,degToRad:Py,radToDeg:Iy,isPowerOfTwo:Ly,ceilPowerOfTwo:Dy,floorPowerOfTwo:Ld,setQuaternionFromProperEuler:Ny,normalize:Nd,denormalize:Dd},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ai=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],p=r[o+1],g=r[o+2],S=r[o+3];if(d!==S||l!==u||c!==p||h!==g){let m=l*u+c*p+h*g+d*S;m<0&&(u=-u,p=-p,g=-g,S=-S,m=-m);let f=1-a;if(m<.9995){let M=Math.acos(m),R=Math.sin(M);f=Math.sin(f*M)/R,a=Math.sin(a*M)/R,l=l*f+u*a,c=c*f+p*a,h=h*f+g*a,d=d*f+S*a}else{l=l*f+u*a,c=c*f+p*a,h=h*f+g*a,d=d*f+S*a;let M=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=M,c*=M,h*=M,d*=M}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],p=r[o+2],g=r[o+3];return t[e]=a*g+h*d+l*p-c*u,t[e+1]=l*g+h*u+c*d-a*p,t[e+2]=c*g+h*p+a*u-l*d,t[e+3]=h*g-a*d-l*u-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d-u*p*g;break;case"YXZ":this._x=u*h*d+c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d+u*p*g;break;case"ZXY":this._x=u*h*d-c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d-u*p*g;break;case"ZYX":this._x=u*h*d-c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d+u*p*g;break;case"YZX":this._x=u*h*d+c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d-u*p*g;break;case"XZY":this._x=u*h*d-c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d+u*p*g;break;default:se("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>d){let p=2*Math.sqrt(1+n-a-d);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>d){let p=2*Math.sqrt(1+a-n-d);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+d-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(bm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(bm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Ru.copy(this).projectOnVector(t),this.sub(Ru)}reflect(t){return this.sub(Ru.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ru=new O,bm=new ai,oe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],p=n[5],g=n[8],S=s[0],m=s[3],f=s[6],M=s[1],R=s[4],v=s[7],C=s[2],A=s[5],_=s[8];return r[0]=o*S+a*M+l*C,r[3]=o*m+a*R+l*A,r[6]=o*f+a*v+l*_,r[1]=c*S+h*M+d*C,r[4]=c*m+h*R+d*A,r[7]=c*f+h*v+d*_,r[2]=u*S+p*M+g*C,r[5]=u*m+p*R+g*A,r[8]=u*f+p*v+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,p=c*r-o*l,g=e*d+n*u+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/g;return t[0]=d*S,t[1]=(s*c-h*n)*S,t[2]=(a*n-s*o)*S,t[3]=u*S,t[4]=(h*e-s*l)*S,t[5]=(s*r-a*e)*S,t[6]=p*S,t[7]=(n*l-c*e)*S,t[8]=(o*e-n*r)*S,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ta("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Pu.makeScale(t,e)),this}rotate(t){return ta("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Pu.makeRotation(-t)),this}translate(t,e){return ta("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Pu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Pu=new oe,wm=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Em=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Uy(){let i={enabled:!0,workingColorSpace:sa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ne&&(s.r=fs(s.r),s.g=fs(s.g),s.b=fs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ne&&(s.r=oo(s.r),s.g=oo(s.g),s.b=oo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ss?ra:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[sa]:{primaries:t,whitePoint:n,transfer:ra,toXYZ:wm,fromXYZ:Em,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Vn},outputColorSpaceConfig:{drawingBufferColorSpace:Vn}},[Vn]:{primaries:t,whitePoint:n,transfer:Ne,toXYZ:wm,fromXYZ:Em,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Vn}}}),i}var we=Uy();function fs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function oo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Hr,nc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Hr===void 0&&(Hr=oa("canvas")),Hr.width=t.width,Hr.height=t.height;let s=Hr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Hr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=oa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=fs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(fs(e[n]/255)*255):e[n]=fs(e[n]);return{data:e,width:t.width,height:t.height}}else return se("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Fy=0,uo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Fy++}),this.uuid=$s(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Iu(s[o].image)):r.push(Iu(s[o]))}else r=Iu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Iu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?nc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(se("Texture: Unable to serialize Texture."),{})}var Oy=0,Lu=new O,Xn=class i extends Ii{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Yi,s=Yi,r=Wn,o=ys,a=Fi,l=Zn,c=i.DEFAULT_ANISOTROPY,h=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Oy++}),this.uuid=$s(),this.name="",this.source=new uo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Lu).x}get height(){return this.source.getSize(Lu).y}get depth(){return this.source.getSize(Lu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){se(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){se(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==xd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ql:t.x=t.x-Math.floor(t.x);break;case Yi:t.x=t.x<0?0:1;break;case tc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ql:t.y=t.y-Math.floor(t.y);break;case Yi:t.y=t.y<0?0:1;break;case tc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Xn.DEFAULT_IMAGE=null;Xn.DEFAULT_MAPPING=xd;Xn.DEFAULT_ANISOTROPY=1;var Ce=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],p=l[5],g=l[9],S=l[2],m=l[6],f=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-S)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+S)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let R=(c+1)/2,v=(p+1)/2,C=(f+1)/2,A=(h+u)/4,_=(d+S)/4,E=(g+m)/4;return R>v&&R>C?R<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(R),s=A/n,r=_/n):v>C?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=A/s,r=E/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=E/r),this.set(n,s,r,e),this}let M=Math.sqrt((m-g)*(m-g)+(d-S)*(d-S)+(u-h)*(u-h));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(d-S)/M,this.z=(u-h)/M,this.w=Math.acos((c+p+f-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ic=class extends Ii{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Wn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ce(0,0,t,e),this.scissorTest=!1,this.viewport=new Ce(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Xn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Wn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new uo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},li=class extends ic{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},la=class extends Xn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Yi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var sc=class extends Xn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Yi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var me=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,d,u,p,g,S,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,d,u,p,g,S,m)}set(t,e,n,s,r,o,a,l,c,h,d,u,p,g,S,m){let f=this.elements;return f[0]=t,f[4]=e,f[8]=n,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=d,f[14]=u,f[3]=p,f[7]=g,f[11]=S,f[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Wr.setFromMatrixColumn(t,0).length(),r=1/Wr.setFromMatrixColumn(t,1).length(),o=1/Wr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,p=o*d,g=a*h,S=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=p+g*c,e[5]=u-S*c,e[9]=-a*l,e[2]=S-u*c,e[6]=g+p*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,p=l*d,g=c*h,S=c*d;e[0]=u+S*a,e[4]=g*a-p,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=p*a-g,e[6]=S+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,p=l*d,g=c*h,S=c*d;e[0]=u-S*a,e[4]=-o*d,e[8]=g+p*a,e[1]=p+g*a,e[5]=o*h,e[9]=S-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,p=o*d,g=a*h,S=a*d;e[0]=l*h,e[4]=g*c-p,e[8]=u*c+S,e[1]=l*d,e[5]=S*c+u,e[9]=p*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,p=o*c,g=a*l,S=a*c;e[0]=l*h,e[4]=S-u*d,e[8]=g*d+p,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=p*d+g,e[10]=u-S*d}else if(t.order==="XZY"){let u=o*l,p=o*c,g=a*l,S=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+S,e[5]=o*h,e[9]=p*d-g,e[2]=g*d-p,e[6]=a*h,e[10]=S*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(By,t,zy)}lookAt(t,e,n){let s=this.elements;return si.subVectors(t,e),si.lengthSq()===0&&(si.z=1),si.normalize(),Ds.crossVectors(n,si),Ds.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ds.crossVectors(n,si)),Ds.normalize(),yl.crossVectors(si,Ds),s[0]=Ds.x,s[4]=yl.x,s[8]=si.x,s[1]=Ds.y,s[5]=yl.y,s[9]=si.y,s[2]=Ds.z,s[6]=yl.z,s[10]=si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],p=n[13],g=n[2],S=n[6],m=n[10],f=n[14],M=n[3],R=n[7],v=n[11],C=n[15],A=s[0],_=s[4],E=s[8],B=s[12],N=s[1],D=s[5],z=s[9],W=s[13],L=s[2],V=s[6],q=s[10],H=s[14],ct=s[3],Y=s[7],j=s[11],it=s[15];return r[0]=o*A+a*N+l*L+c*ct,r[4]=o*_+a*D+l*V+c*Y,r[8]=o*E+a*z+l*q+c*j,r[12]=o*B+a*W+l*H+c*it,r[1]=h*A+d*N+u*L+p*ct,r[5]=h*_+d*D+u*V+p*Y,r[9]=h*E+d*z+u*q+p*j,r[13]=h*B+d*W+u*H+p*it,r[2]=g*A+S*N+m*L+f*ct,r[6]=g*_+S*D+m*V+f*Y,r[10]=g*E+S*z+m*q+f*j,r[14]=g*B+S*W+m*H+f*it,r[3]=M*A+R*N+v*L+C*ct,r[7]=M*_+R*D+v*V+C*Y,r[11]=M*E+R*z+v*q+C*j,r[15]=M*B+R*W+v*H+C*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],p=t[14],g=t[3],S=t[7],m=t[11],f=t[15],M=l*p-c*u,R=a*p-c*d,v=a*u-l*d,C=o*p-c*h,A=o*u-l*h,_=o*d-a*h;return e*(S*M-m*R+f*v)-n*(g*M-m*C+f*A)+s*(g*R-S*C+f*_)-r*(g*v-S*A+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],p=t[11],g=t[12],S=t[13],m=t[14],f=t[15],M=e*a-n*o,R=e*l-s*o,v=e*c-r*o,C=n*l-s*a,A=n*c-r*a,_=s*c-r*l,E=h*S-d*g,B=h*m-u*g,N=h*f-p*g,D=d*m-u*S,z=d*f-p*S,W=u*f-p*m,L=M*W-R*z+v*D+C*N-A*B+_*E;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/L;return t[0]=(a*W-l*z+c*D)*V,t[1]=(s*z-n*W-r*D)*V,t[2]=(S*_-m*A+f*C)*V,t[3]=(u*A-d*_-p*C)*V,t[4]=(l*N-o*W-c*B)*V,t[5]=(e*W-s*N+r*B)*V,t[6]=(m*v-g*_-f*R)*V,t[7]=(h*_-u*v+p*R)*V,t[8]=(o*z-a*N+c*E)*V,t[9]=(n*N-e*z-r*E)*V,t[10]=(g*A-S*v+f*M)*V,t[11]=(d*v-h*A-p*M)*V,t[12]=(a*B-o*D-l*E)*V,t[13]=(e*D-n*B+s*E)*V,t[14]=(S*R-g*C-m*M)*V,t[15]=(h*C-d*R+u*M)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,p=r*h,g=r*d,S=o*h,m=o*d,f=a*d,M=l*c,R=l*h,v=l*d,C=n.x,A=n.y,_=n.z;return s[0]=(1-(S+f))*C,s[1]=(p+v)*C,s[2]=(g-R)*C,s[3]=0,s[4]=(p-v)*A,s[5]=(1-(u+f))*A,s[6]=(m+M)*A,s[7]=0,s[8]=(g+R)*_,s[9]=(m-M)*_,s[10]=(1-(u+S))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Wr.set(s[0],s[1],s[2]).length(),a=Wr.set(s[4],s[5],s[6]).length(),l=Wr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,h=1/a,d=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=h,Ci.elements[5]*=h,Ci.elements[6]*=h,Ci.elements[8]*=d,Ci.elements[9]*=d,Ci.elements[10]*=d,e.setFromRotationMatrix(Ci),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=yi,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(n-s),u=(e+t)/(e-t),p=(n+s)/(n-s),g,S;if(l)g=r/(o-r),S=o*r/(o-r);else if(a===yi)g=-(o+r)/(o-r),S=-2*o*r/(o-r);else if(a===lo)g=-o/(o-r),S=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=S,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=yi,l=!1){let c=this.elements,h=2/(e-t),d=2/(n-s),u=-(e+t)/(e-t),p=-(n+s)/(n-s),g,S;if(l)g=1/(o-r),S=o/(o-r);else if(a===yi)g=-2/(o-r),S=-(o+r)/(o-r);else if(a===lo)g=-1/(o-r),S=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=S,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Wr=new O,Ci=new me,By=new O(0,0,0),zy=new O(1,1,1),Ds=new O,yl=new O,si=new O,Tm=new me,Am=new ai,ms=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ve(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:se("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Tm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Tm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Am.setFromEuler(this),this.setFromQuaternion(Am,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ms.DEFAULT_ORDER="XYZ";var fo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},ky=0,Cm=new O,Xr=new ai,as=new me,vl=new O,qo=new O,Gy=new O,Vy=new ai,Rm=new O(1,0,0),Pm=new O(0,1,0),Im=new O(0,0,1),Lm={type:"added"},Hy={type:"removed"},qr={type:"childadded",child:null},Du={type:"childremoved",child:null},xn=class i extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ky++}),this.uuid=$s(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new O,e=new ms,n=new ai,s=new O(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new me},normalMatrix:{value:new oe}}),this.matrix=new me,this.matrixWorld=new me,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new fo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Xr.setFromAxisAngle(t,e),this.quaternion.multiply(Xr),this}rotateOnWorldAxis(t,e){return Xr.setFromAxisAngle(t,e),this.quaternion.premultiply(Xr),this}rotateX(t){return this.rotateOnAxis(Rm,t)}rotateY(t){return this.rotateOnAxis(Pm,t)}rotateZ(t){return this.rotateOnAxis(Im,t)}translateOnAxis(t,e){return Cm.copy(t).applyQuaternion(this.quaternion),this.position.add(Cm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Rm,t)}translateY(t){return this.translateOnAxis(Pm,t)}translateZ(t){return this.translateOnAxis(Im,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(as.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?vl.copy(t):vl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),qo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?as.lookAt(qo,vl,this.up):as.lookAt(vl,qo,this.up),this.quaternion.setFromRotationMatrix(as),s&&(as.extractRotation(s.matrixWorld),Xr.setFromRotationMatrix(as),this.quaternion.premultiply(Xr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ce("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Lm),qr.child=t,this.dispatchEvent(qr),qr.child=null):ce("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Hy),Du.child=t,this.dispatchEvent(Du),Du.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),as.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),as.multiply(t.parent.matrixWorld)),t.applyMatrix4(as),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Lm),qr.child=t,this.dispatchEvent(qr),qr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qo,t,Gy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qo,Vy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),p=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};xn.DEFAULT_UP=new O(0,1,0);xn.DEFAULT_MATRIX_AUTO_UPDATE=!0;xn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Pn=class extends xn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Wy={type:"move"},po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Pn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Pn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Pn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let S of t.hand.values()){let m=e.getJointPose(S,n),f=this._getHandJoint(c,S);m!==null&&(f.matrix.fromArray(m.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=m.radius),f.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),p=.02,g=.005;c.inputState.pinching&&u>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Wy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Pn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Og={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ns={h:0,s:0,l:0},Sl={h:0,s:0,l:0};function Nu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ee=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Vn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,we.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=we.workingColorSpace){return this.r=t,this.g=e,this.b=n,we.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=we.workingColorSpace){if(t=Id(t,1),e=ve(e,0,1),n=ve(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Nu(o,r,t+1/3),this.g=Nu(o,r,t),this.b=Nu(o,r,t-1/3)}return we.colorSpaceToWorking(this,s),this}setStyle(t,e=Vn){function n(r){r!==void 0&&parseFloat(r)<1&&se("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:se("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);se("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Vn){let n=Og[t.toLowerCase()];return n!==void 0?this.setHex(n,e):se("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=fs(t.r),this.g=fs(t.g),this.b=fs(t.b),this}copyLinearToSRGB(t){return this.r=oo(t.r),this.g=oo(t.g),this.b=oo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Vn){return we.workingToColorSpace(Nn.copy(this),t),Math.round(ve(Nn.r*255,0,255))*65536+Math.round(ve(Nn.g*255,0,255))*256+Math.round(ve(Nn.b*255,0,255))}getHexString(t=Vn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=we.workingColorSpace){we.workingToColorSpace(Nn.copy(this),e);let n=Nn.r,s=Nn.g,r=Nn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=we.workingColorSpace){return we.workingToColorSpace(Nn.copy(this),e),t.r=Nn.r,t.g=Nn.g,t.b=Nn.b,t}getStyle(t=Vn){we.workingToColorSpace(Nn.copy(this),t);let e=Nn.r,n=Nn.g,s=Nn.b;return t!==Vn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ns),this.setHSL(Ns.h+t,Ns.s+e,Ns.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ns),t.getHSL(Sl);let n=na(Ns.h,Sl.h,e),s=na(Ns.s,Sl.s,e),r=na(Ns.l,Sl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Nn=new ee;ee.NAMES=Og;var ca=class extends xn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ms,this.environmentIntensity=1,this.environmentRotation=new ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new O,ls=new O,Uu=new O,cs=new O,Yr=new O,$r=new O,Dm=new O,Fu=new O,Ou=new O,Bu=new O,zu=new Ce,ku=new Ce,Gu=new Ce,ds=class i{constructor(t=new O,e=new O,n=new O){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ri.subVectors(s,e),ls.subVectors(n,e),Uu.subVectors(t,e);let o=Ri.dot(Ri),a=Ri.dot(ls),l=Ri.dot(Uu),c=ls.dot(ls),h=ls.dot(Uu),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,p=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-p-g,g,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,cs)===null?!1:cs.x>=0&&cs.y>=0&&cs.x+cs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,cs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,cs.x),l.addScaledVector(o,cs.y),l.addScaledVector(a,cs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return zu.setScalar(0),ku.setScalar(0),Gu.setScalar(0),zu.fromBufferAttribute(t,e),ku.fromBufferAttribute(t,n),Gu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zu,r.x),o.addScaledVector(ku,r.y),o.addScaledVector(Gu,r.z),o}static isFrontFacing(t,e,n,s){return Ri.subVectors(n,e),ls.subVectors(t,e),Ri.cross(ls).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),ls.subVectors(this.a,this.b),Ri.cross(ls).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Yr.subVectors(s,n),$r.subVectors(r,n),Fu.subVectors(t,n);let l=Yr.dot(Fu),c=$r.dot(Fu);if(l<=0&&c<=0)return e.copy(n);Ou.subVectors(t,s);let h=Yr.dot(Ou),d=$r.dot(Ou);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Yr,o);Bu.subVectors(t,r);let p=Yr.dot(Bu),g=$r.dot(Bu);if(g>=0&&p<=g)return e.copy(r);let S=p*c-l*g;if(S<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector($r,a);let m=h*g-p*d;if(m<=0&&d-h>=0&&p-g>=0)return Dm.subVectors(r,s),a=(d-h)/(d-h+(p-g)),e.copy(s).addScaledVector(Dm,a);let f=1/(m+S+u);return o=S*f,a=u*f,e.copy(n).addScaledVector(Yr,o).addScaledVector($r,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ci=class{constructor(t=new O(1/0,1/0,1/0),e=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ml.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ml.copy(n.boundingBox)),Ml.applyMatrix4(t.matrixWorld),this.union(Ml)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Yo),bl.subVectors(this.max,Yo),Zr.subVectors(t.a,Yo),Jr.subVectors(t.b,Yo),Kr.subVectors(t.c,Yo),Us.subVectors(Jr,Zr),Fs.subVectors(Kr,Jr),rr.subVectors(Zr,Kr);let e=[0,-Us.z,Us.y,0,-Fs.z,Fs.y,0,-rr.z,rr.y,Us.z,0,-Us.x,Fs.z,0,-Fs.x,rr.z,0,-rr.x,-Us.y,Us.x,0,-Fs.y,Fs.x,0,-rr.y,rr.x,0];return!Vu(e,Zr,Jr,Kr,bl)||(e=[1,0,0,0,1,0,0,0,1],!Vu(e,Zr,Jr,Kr,bl))?!1:(wl.crossVectors(Us,Fs),e=[wl.x,wl.y,wl.z],Vu(e,Zr,Jr,Kr,bl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(hs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),hs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),hs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),hs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),hs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),hs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),hs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),hs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(hs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},hs=[new O,new O,new O,new O,new O,new O,new O,new O],Pi=new O,Ml=new ci,Zr=new O,Jr=new O,Kr=new O,Us=new O,Fs=new O,rr=new O,Yo=new O,bl=new O,wl=new O,or=new O;function Vu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){or.fromArray(i,r);let a=s.x*Math.abs(or.x)+s.y*Math.abs(or.y)+s.z*Math.abs(or.z),l=t.dot(or),c=e.dot(or),h=n.dot(or);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var fn=new O,El=new Zt,Xy=0,An=class extends Ii{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Xy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Rd,this.updateRanges=[],this.gpuType=Ni,this.version=0,this._normalizationScale=t!==void 0?dh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)El.fromBufferAttribute(this,e),El.applyMatrix3(t),this.setXY(e,El.x,El.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix3(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix4(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyNormalMatrix(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.transformDirection(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Dd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Nd(t,this.array)}};var ha=class extends An{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ua=class extends An{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var ze=class extends An{constructor(t,e,n){super(new Float32Array(t),e,n)}},qy=new ci,$o=new O,Hu=new O,cr=class{constructor(t=new O,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):qy.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$o.subVectors(t,this.center);let e=$o.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector($o,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Hu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($o.copy(t.center).add(Hu)),this.expandByPoint($o.copy(t.center).sub(Hu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Yy=0,xi=new me,Wu=new xn,jr=new O,ri=new ci,Zo=new ci,Tn=new O,Qe=class i extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Yy++}),this.uuid=$s(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(xy(t)?ua:ha)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new oe().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return xi.makeRotationFromQuaternion(t),this.applyMatrix4(xi),this}rotateX(t){return xi.makeRotationX(t),this.applyMatrix4(xi),this}rotateY(t){return xi.makeRotationY(t),this.applyMatrix4(xi),this}rotateZ(t){return xi.makeRotationZ(t),this.applyMatrix4(xi),this}translate(t,e,n){return xi.makeTranslation(t,e,n),this.applyMatrix4(xi),this}scale(t,e,n){return xi.makeScale(t,e,n),this.applyMatrix4(xi),this}lookAt(t){return Wu.lookAt(t),Wu.updateMatrix(),this.applyMatrix4(Wu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ze(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&se("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Tn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(Tn),Tn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(Tn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ce('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new cr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(t){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Zo.setFromBufferAttribute(a),this.morphTargetsRelative?(Tn.addVectors(ri.min,Zo.min),ri.expandByPoint(Tn),Tn.addVectors(ri.max,Zo.max),ri.expandByPoint(Tn)):(ri.expandByPoint(Zo.min),ri.expandByPoint(Zo.max))}ri.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Tn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Tn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Tn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(t,c),Tn.add(jr)),s=Math.max(s,n.distanceToSquared(Tn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ce('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ce("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new An(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let B=0;B<n.count;B++)a[B]=new O,l[B]=new O;let h=new O,d=new O,u=new O,p=new Zt,g=new Zt,S=new Zt,m=new O,f=new O;function M(B,N,D){c[B]=c[N]=c[D]=1,h.fromBufferAttribute(n,B),d.fromBufferAttribute(n,N),u.fromBufferAttribute(n,D),p.fromBufferAttribute(r,B),g.fromBufferAttribute(r,N),S.fromBufferAttribute(r,D),d.sub(h),u.sub(h),g.sub(p),S.sub(p);let z=1/(g.x*S.y-S.x*g.y);isFinite(z)&&(m.copy(d).multiplyScalar(S.y).addScaledVector(u,-g.y).multiplyScalar(z),f.copy(u).multiplyScalar(g.x).addScaledVector(d,-S.x).multiplyScalar(z),a[B].add(m),a[N].add(m),a[D].add(m),l[B].add(f),l[N].add(f),l[D].add(f))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let B=0,N=R.length;B<N;++B){let D=R[B],z=D.start,W=D.count;for(let L=z,V=z+W;L<V;L+=3)M(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let v=new O,C=new O,A=new O,_=new O;function E(B){A.fromBufferAttribute(s,B),_.copy(A);let N=a[B];v.copy(N),v.sub(A.multiplyScalar(A.dot(N))).normalize(),C.crossVectors(_,N);let z=C.dot(l[B])<0?-1:1;o.setXYZW(B,v.x,v.y,v.z,z)}for(let B=0,N=n.count;B<N;++B)c[B]&&E(B);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new An(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,p=n.count;u<p;u++)n.setXYZ(u,0,0,0);let s=new O,r=new O,o=new O,a=new O,l=new O,c=new O,h=new O,d=new O;if(t)for(let u=0,p=t.count;u<p;u+=3){let g=t.getX(u+0),S=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,S),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,S),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(S,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,p=e.count;u<p;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Tn.fromBufferAttribute(t,e),Tn.normalize(),t.setXYZ(e,Tn.x,Tn.y,Tn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),p=0,g=0;for(let S=0,m=l.length;S<m;S++){a.isInterleavedBufferAttribute?p=l[S]*a.data.stride+a.offset:p=l[S]*h;for(let f=0;f<h;f++)u[g++]=c[p++]}return new An(u,h,d)}if(this.index===null)return se("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],p=t(u,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let p=c[d];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,p=d.length;u<p;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},da=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Rd,this.updateRanges=[],this.version=0,this.uuid=$s()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Nm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Nm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Nm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=$s()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Gn=new O,mo=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?dh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Gn.fromBufferAttribute(this,e),Gn.applyMatrix4(t),this.setXYZ(e,Gn.x,Gn.y,Gn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Gn.fromBufferAttribute(this,e),Gn.applyNormalMatrix(t),this.setXYZ(e,Gn.x,Gn.y,Gn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Gn.fromBufferAttribute(this,e),Gn.transformDirection(t),this.setXYZ(e,Gn.x,Gn.y,Gn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){aa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new An(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){aa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Dd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Nd(t,this.data.array)}},Xu=new O,$y=new O,Zy=new oe,oi=class{constructor(t=new O(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Xu.subVectors(n,e).cross($y.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Xu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Zy.getNormalMatrix(t),s=this.coplanarPoint(Xu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Jy=0,$i=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Jy++}),this.uuid=$s(),this.name="",this.type="Material",this.blending=bo,this.side=qs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=cd,this.blendDst=hd,this.blendEquation=fr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=ao,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ag,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Xl,this.stencilZFail=Xl,this.stencilZPass=Xl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){se(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){se(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new oi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Zt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},go=class extends $i{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Qr,Jo=new O,to=new O,eo=new O,no=new Zt,Ko=new Zt,Bg=new me,Tl=new O,jo=new O,Al=new O,Um=new Zt,qu=new Zt,Fm=new Zt,gs=class extends xn{constructor(t=new go){if(super(),this.isSprite=!0,this.type="Sprite",Qr===void 0){Qr=new Qe;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new da(e,5);Qr.setIndex([0,1,2,0,2,3]),Qr.setAttribute("position",new mo(n,3,0,!1)),Qr.setAttribute("uv",new mo(n,2,3,!1))}this.geometry=Qr,this.material=t,this.center=new Zt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ce('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),to.setFromMatrixScale(this.matrixWorld),Bg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),eo.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&to.multiplyScalar(-eo.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Cl(Tl.set(-.5,-.5,0),eo,o,to,s,r),Cl(jo.set(.5,-.5,0),eo,o,to,s,r),Cl(Al.set(.5,.5,0),eo,o,to,s,r),Um.set(0,0),qu.set(1,0),Fm.set(1,1);let a=t.ray.intersectTriangle(Tl,jo,Al,!1,Jo);if(a===null&&(Cl(jo.set(-.5,.5,0),eo,o,to,s,r),qu.set(0,1),a=t.ray.intersectTriangle(Tl,Al,jo,!1,Jo),a===null))return;let l=t.ray.origin.distanceTo(Jo);l<t.near||l>t.far||e.push({distance:l,point:Jo.clone(),uv:ds.getInterpolation(Jo,Tl,jo,Al,Um,qu,Fm,new Zt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Cl(i,t,e,n,s,r){no.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(Ko.x=r*no.x-s*no.y,Ko.y=s*no.x+r*no.y):Ko.copy(no),i.copy(t),i.x+=Ko.x,i.y+=Ko.y,i.applyMatrix4(Bg)}var us=new O,Yu=new O,Rl=new O,Pl=new O,Bs=class{constructor(t=new O,e=new O(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,us)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=us.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(us.copy(this.origin).addScaledVector(this.direction,e),us.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Yu.copy(t).add(e).multiplyScalar(.5),Rl.copy(e).sub(t).normalize(),Pl.copy(this.origin).sub(Yu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Rl),a=Pl.dot(this.direction),l=-Pl.dot(Rl),c=Pl.lengthSq(),h=Math.abs(1-o*o),d,u,p,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let S=1/h;d*=S,u*=S,p=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),p=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),p=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),p=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Yu).addScaledVector(Rl,u),p}intersectSphere(t,e){if(t.radius<0)return null;us.subVectors(t.center,this.origin);let n=us.dot(this.direction),s=us.dot(us)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,us)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,p=t.z-o.z,g=e.x-o.x,S=e.y-o.y,m=e.z-o.z,f=n.x-o.x,M=n.y-o.y,R=n.z-o.z,v=Math.abs(l),C=Math.abs(c),A=Math.abs(h),_,E,B,N,D,z,W,L,V,q,H,ct;if(v>=C&&v>=A?(B=l,z=d,V=g,ct=f,l>=0?(_=c,E=h,N=u,D=p,W=S,L=m,q=M,H=R):(_=h,E=c,N=p,D=u,W=m,L=S,q=R,H=M)):C>=A?(B=c,z=u,V=S,ct=M,c>=0?(_=h,E=l,N=p,D=d,W=m,L=g,q=R,H=f):(_=l,E=h,N=d,D=p,W=g,L=m,q=f,H=R)):(B=h,z=p,V=m,ct=R,h>=0?(_=l,E=c,N=d,D=u,W=g,L=S,q=f,H=M):(_=c,E=l,N=u,D=d,W=S,L=g,q=M,H=f)),B===0)return null;let Y=_/B,j=E/B,it=1/B,pt=N-Y*z,ht=D-j*z,tt=W-Y*V,gt=L-j*V,Mt=q-Y*ct,Lt=H-j*ct,At=Mt*gt-Lt*tt,jt=pt*Lt-ht*Mt,he=tt*ht-gt*pt;if(s){if(At<0||jt<0||he<0)return null}else if((At<0||jt<0||he<0)&&(At>0||jt>0||he>0))return null;let Jt=At+jt+he;if(Jt===0)return null;let de=it*(At*z+jt*V+he*ct);return(Jt>0?de<0:de>0)?null:this.at(de/Jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rc=class extends $i{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=Ec,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Om=new me,ar=new Bs,Il=new cr,Bm=new O,Ll=new O,Dl=new O,Nl=new O,$u=new O,Ul=new O,zm=new O,Fl=new O,an=class extends xn{constructor(t=new Qe,e=new rc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ul.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&($u.fromBufferAttribute(d,t),o?Ul.addScaledVector($u,h):Ul.addScaledVector($u.sub(e),h))}e.add(Ul)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Il.copy(n.boundingSphere),Il.applyMatrix4(r),ar.copy(t.ray).recast(t.near),!(Il.containsPoint(ar.origin)===!1&&(ar.intersectSphere(Il,Bm)===null||ar.origin.distanceToSquared(Bm)>(t.far-t.near)**2))&&(Om.copy(r).invert(),ar.copy(t.ray).applyMatrix4(Om),!(n.boundingBox!==null&&ar.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ar)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,S=u.length;g<S;g++){let m=u[g],f=o[m.materialIndex],M=Math.max(m.start,p.start),R=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let v=M,C=R;v<C;v+=3){let A=a.getX(v),_=a.getX(v+1),E=a.getX(v+2);s=Ol(this,f,t,n,c,h,d,A,_,E),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),S=Math.min(a.count,p.start+p.count);for(let m=g,f=S;m<f;m+=3){let M=a.getX(m),R=a.getX(m+1),v=a.getX(m+2);s=Ol(this,o,t,n,c,h,d,M,R,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,S=u.length;g<S;g++){let m=u[g],f=o[m.materialIndex],M=Math.max(m.start,p.start),R=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let v=M,C=R;v<C;v+=3){let A=v,_=v+1,E=v+2;s=Ol(this,f,t,n,c,h,d,A,_,E),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),S=Math.min(l.count,p.start+p.count);for(let m=g,f=S;m<f;m+=3){let M=m,R=m+1,v=m+2;s=Ol(this,o,t,n,c,h,d,M,R,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Ky(i,t,e,n,s,r,o,a){let l;if(t.side===qn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===qs,a),l===null)return null;Fl.copy(a),Fl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Fl);return c<e.near||c>e.far?null:{distance:c,point:Fl.clone(),object:i}}function Ol(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Ll),i.getVertexPosition(l,Dl),i.getVertexPosition(c,Nl);let h=Ky(i,t,e,n,Ll,Dl,Nl,zm);if(h){let d=new O;ds.getBarycoord(zm,Ll,Dl,Nl,d),s&&(h.uv=ds.getInterpolatedAttribute(s,a,l,c,d,new Zt)),r&&(h.uv1=ds.getInterpolatedAttribute(r,a,l,c,d,new Zt)),o&&(h.normal=ds.getInterpolatedAttribute(o,a,l,c,d,new O),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new O,materialIndex:0};ds.getNormal(Ll,Dl,Nl,u.normal),h.face=u,h.barycoord=d}return h}var oc=class extends Xn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Cn,h=Cn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var lr=new cr,jy=new Zt(.5,.5),Bl=new O,Zi=class{constructor(t=new oi,e=new oi,n=new oi,s=new oi,r=new oi,o=new oi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=yi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],p=r[7],g=r[8],S=r[9],m=r[10],f=r[11],M=r[12],R=r[13],v=r[14],C=r[15];if(s[0].setComponents(c-o,p-h,f-g,C-M).normalize(),s[1].setComponents(c+o,p+h,f+g,C+M).normalize(),s[2].setComponents(c+a,p+d,f+S,C+R).normalize(),s[3].setComponents(c-a,p-d,f-S,C-R).normalize(),n)s[4].setComponents(l,u,m,v).normalize(),s[5].setComponents(c-l,p-u,f-m,C-v).normalize();else if(s[4].setComponents(c-l,p-u,f-m,C-v).normalize(),e===yi)s[5].setComponents(c+l,p+u,f+m,C+v).normalize();else if(e===lo)s[5].setComponents(l,u,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),lr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),lr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(lr)}intersectsSprite(t){lr.center.set(0,0,0);let e=jy.distanceTo(t.center);return lr.radius=.7071067811865476+e,lr.applyMatrix4(t.matrixWorld),this.intersectsSphere(lr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Bl.x=s.normal.x>0?t.max.x:t.min.x,Bl.y=s.normal.y>0?t.max.y:t.min.y,Bl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Bl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},km=new me,ac=class i{constructor(){this.coordinateSystem=yi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];km.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Zi),n[s].setFromProjectionMatrix(km,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Zi),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var zs=class extends $i{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},lc=new O,cc=new O,Gm=new me,Qo=new Bs,zl=new cr,Zu=new O,Vm=new O,_s=class extends xn{constructor(t=new Qe,e=new zs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)lc.fromBufferAttribute(e,s-1),cc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=lc.distanceTo(cc);t.setAttribute("lineDistance",new ze(n,1))}else se("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),zl.copy(n.boundingSphere),zl.applyMatrix4(s),zl.radius+=r,t.ray.intersectsSphere(zl)===!1)return;Gm.copy(s).invert(),Qo.copy(t.ray).applyMatrix4(Gm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let S=p,m=g-1;S<m;S+=c){let f=h.getX(S),M=h.getX(S+1),R=kl(this,t,Qo,l,f,M,S);R&&e.push(R)}if(this.isLineLoop){let S=h.getX(g-1),m=h.getX(p),f=kl(this,t,Qo,l,S,m,g-1);f&&e.push(f)}}else{let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let S=p,m=g-1;S<m;S+=c){let f=kl(this,t,Qo,l,S,S+1,S);f&&e.push(f)}if(this.isLineLoop){let S=kl(this,t,Qo,l,g-1,p,g-1);S&&e.push(S)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function kl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),e.distanceSqToSegment(lc,cc,Zu,Vm)>n)return;Zu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Zu);if(!(c<t.near||c>t.far))return{distance:c,point:Vm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Hm=new O,Wm=new O,_o=class extends _s{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Hm.fromBufferAttribute(e,s),Wm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Hm.distanceTo(Wm);t.setAttribute("lineDistance",new ze(n,1))}else se("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var fa=class extends Xn{constructor(t=[],e=pr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},pa=class extends Xn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var xs=class extends Xn{constructor(t,e,n=Di,s,r,o,a=Cn,l=Cn,c,h=ps,d=1){if(h!==ps&&h!==vs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new uo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ma=class extends xs{constructor(t,e=Di,n=pr,s,r,o=Cn,a=Cn,l,c=ps){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ga=class extends Xn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},$n=class i extends Qe{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,p=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ze(c,3)),this.setAttribute("normal",new ze(h,3)),this.setAttribute("uv",new ze(d,2));function g(S,m,f,M,R,v,C,A,_,E,B){let N=v/_,D=C/E,z=v/2,W=C/2,L=A/2,V=_+1,q=E+1,H=0,ct=0,Y=new O;for(let j=0;j<q;j++){let it=j*D-W;for(let pt=0;pt<V;pt++){let ht=pt*N-z;Y[S]=ht*M,Y[m]=it*R,Y[f]=L,c.push(Y.x,Y.y,Y.z),Y[S]=0,Y[m]=0,Y[f]=A>0?1:-1,h.push(Y.x,Y.y,Y.z),d.push(pt/_),d.push(1-j/E),H+=1}}for(let j=0;j<E;j++)for(let it=0;it<_;it++){let pt=u+it+V*j,ht=u+it+V*(j+1),tt=u+(it+1)+V*(j+1),gt=u+(it+1)+V*j;l.push(pt,ht,gt),l.push(ht,tt,gt),ct+=6}a.addGroup(p,ct,B),p+=ct,u+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var _a=class i extends Qe{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],p=[],g=0,S=[],m=n/2,f=0;M(),o===!1&&(t>0&&R(!0),e>0&&R(!1)),this.setIndex(h),this.setAttribute("position",new ze(d,3)),this.setAttribute("normal",new ze(u,3)),this.setAttribute("uv",new ze(p,2));function M(){let v=new O,C=new O,A=0,_=(e-t)/n;for(let E=0;E<=r;E++){let B=[],N=E/r,D=N*(e-t)+t;for(let z=0;z<=s;z++){let W=z/s,L=W*l+a,V=Math.sin(L),q=Math.cos(L);C.x=D*V,C.y=-N*n+m,C.z=D*q,d.push(C.x,C.y,C.z),v.set(V,_,q).normalize(),u.push(v.x,v.y,v.z),p.push(W,1-N),B.push(g++)}S.push(B)}for(let E=0;E<s;E++)for(let B=0;B<r;B++){let N=S[B][E],D=S[B+1][E],z=S[B+1][E+1],W=S[B][E+1];(t>0||B!==0)&&(h.push(N,D,W),A+=3),(e>0||B!==r-1)&&(h.push(D,z,W),A+=3)}c.addGroup(f,A,0),f+=A}function R(v){let C=g,A=new Zt,_=new O,E=0,B=v===!0?t:e,N=v===!0?1:-1;for(let z=1;z<=s;z++)d.push(0,m*N,0),u.push(0,N,0),p.push(.5,.5),g++;let D=g;for(let z=0;z<=s;z++){let L=z/s*l+a,V=Math.cos(L),q=Math.sin(L);_.x=B*q,_.y=m*N,_.z=B*V,d.push(_.x,_.y,_.z),u.push(0,N,0),A.x=V*.5+.5,A.y=q*.5*N+.5,p.push(A.x,A.y),g++}for(let z=0;z<s;z++){let W=C+z,L=D+z;v===!0?h.push(L,L+1,W):h.push(L+1,L,W),E+=3}c.addGroup(f,E,v===!0?1:2),f+=E}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var xa=class i extends Qe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,p=[],g=[],S=[],m=[];for(let f=0;f<h;f++){let M=f*u-o;for(let R=0;R<c;R++){let v=R*d-r;g.push(v,-M,0),S.push(0,0,1),m.push(R/a),m.push(1-f/l)}}for(let f=0;f<l;f++)for(let M=0;M<a;M++){let R=M+c*f,v=M+c*(f+1),C=M+1+c*(f+1),A=M+1+c*f;p.push(R,v,A),p.push(v,C,A)}this.setIndex(p),this.setAttribute("position",new ze(g,3)),this.setAttribute("normal",new ze(S,3)),this.setAttribute("uv",new ze(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var ya=class i extends Qe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new O,u=new O,p=[],g=[],S=[],m=[];for(let f=0;f<=n;f++){let M=[],R=f/n,v=o+R*a,C=t*Math.cos(v),A=Math.sqrt(t*t-C*C),_=0;f===0&&o===0?_=.5/e:f===n&&l===Math.PI&&(_=-.5/e);for(let E=0;E<=e;E++){let B=E/e,N=s+B*r;d.x=-A*Math.cos(N),d.y=C,d.z=A*Math.sin(N),g.push(d.x,d.y,d.z),u.copy(d).normalize(),S.push(u.x,u.y,u.z),m.push(B+_,1-R),M.push(c++)}h.push(M)}for(let f=0;f<n;f++)for(let M=0;M<e;M++){let R=h[f][M+1],v=h[f][M],C=h[f+1][M],A=h[f+1][M+1];(f!==0||o>0)&&p.push(R,v,A),(f!==n-1||l<Math.PI)&&p.push(v,C,A)}this.setIndex(p),this.setAttribute("position",new ze(g,3)),this.setAttribute("normal",new ze(S,3)),this.setAttribute("uv",new ze(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var hr=class i extends Qe{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],d=[],u=new O,p=new O,g=new O;for(let S=0;S<=n;S++){let m=o+S/n*a;for(let f=0;f<=s;f++){let M=f/s*r;p.x=(t+e*Math.cos(m))*Math.cos(M),p.y=(t+e*Math.cos(m))*Math.sin(M),p.z=e*Math.sin(m),c.push(p.x,p.y,p.z),u.x=t*Math.cos(M),u.y=t*Math.sin(M),g.subVectors(p,u).normalize(),h.push(g.x,g.y,g.z),d.push(f/s),d.push(S/n)}}for(let S=1;S<=n;S++)for(let m=1;m<=s;m++){let f=(s+1)*S+m-1,M=(s+1)*(S-1)+m-1,R=(s+1)*(S-1)+m,v=(s+1)*S+m;l.push(f,M,v),l.push(M,R,v)}this.setIndex(l),this.setAttribute("position",new ze(c,3)),this.setAttribute("normal",new ze(h,3)),this.setAttribute("uv",new ze(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function gr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Xm(s))s.isRenderTargetTexture?(se("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Xm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Un(i){let t={};for(let e=0;e<i.length;e++){let n=gr(i[e]);for(let s in n)t[s]=n[s]}return t}function Xm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Qy(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Ud(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:we.workingColorSpace}var zg={clone:gr,merge:Un},tv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ev=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ji=class extends $i{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tv,this.fragmentShader=ev,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=gr(t.uniforms),this.uniformsGroups=Qy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new ee().setHex(s.value);break;case"v2":this.uniforms[n].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new O().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ce().fromArray(s.value);break;case"m3":this.uniforms[n].value=new oe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new me().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},hc=class extends Ji{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Li=class extends $i{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ee(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=uh,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=Ec,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},uc=class extends $i{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Eg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},dc=class extends $i{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function io(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Gl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ks=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},fc=class extends ks{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ju,endingEnd:ju}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Qu:r=t,a=2*e-n;break;case td:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Qu:o=t,l=2*n-e;break;case td:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,p=this._weightNext,g=(n-e)/(s-e),S=g*g,m=S*g,f=-u*m+2*u*S-u*g,M=(1+u)*m+(-1.5-2*u)*S+(-.5+u)*g+1,R=(-1-p)*m+(1.5+p)*S+.5*g,v=p*m-p*S;for(let C=0;C!==a;++C)r[C]=f*o[h+C]+M*o[c+C]+R*o[l+C]+v*o[d+C];return r}},pc=class extends ks{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},mc=class extends ks{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},gc=class extends ks{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(n-e)/(s-e),S=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*S+o[l+m]*g;return r}let u=a*2,p=t-1;for(let g=0;g!==a;++g){let S=o[c+g],m=o[l+g],f=p*u+g*2,M=d[f],R=d[f+1],v=t*u+g*2,C=h[v],A=h[v+1],_=iv(n,e,M,C,s);r[g]=kg(_,S,R,A,m)}return r}};function kg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function nv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function iv(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=kg(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=nv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=io(e,this.TimeBufferType),this.values=io(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:io(t.times,Array),values:io(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Gl(t.settings)&&(n.settings={inTangents:io(t.settings.inTangents,Array),outTangents:io(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new pc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new fc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new gc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ia:e=this.InterpolantFactoryMethodDiscrete;break;case ec:e=this.InterpolantFactoryMethodLinear;break;case Wl:e=this.InterpolantFactoryMethodSmooth;break;case Ku:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return se("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ia;case this.InterpolantFactoryMethodLinear:return ec;case this.InterpolantFactoryMethodSmooth:return Wl;case this.InterpolantFactoryMethodBezier:return Ku}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Gl(this.settings)&&(qm(this.settings.inTangents,t),qm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Gl(this.settings)&&(Ym(this.settings.inTangents,t),Ym(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ce("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ce("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ce("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ce("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&yy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ce("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Wl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*n,u=d-n,p=d+n;for(let g=0;g!==n;++g){let S=e[d+g];if(S!==e[u+g]||S!==e[p+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let p=0;p!==n;++p)e[u+p]=e[d+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Gl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function qm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Ym(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=ec;var Gs=class extends hi{constructor(t,e,n){super(t,e,n)}};Gs.prototype.ValueTypeName="bool";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=ia;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var _c=class extends hi{constructor(t,e,n,s){super(t,e,n,s)}};_c.prototype.ValueTypeName="color";var xc=class extends hi{constructor(t,e,n,s){super(t,e,n,s)}};xc.prototype.ValueTypeName="number";var yc=class extends ks{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)ai.slerpFlat(r,0,o,c-a,o,c,l);return r}},va=class extends hi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new yc(this.times,this.values,this.getValueSize(),t)}};va.prototype.ValueTypeName="quaternion";va.prototype.InterpolantFactoryMethodSmooth=void 0;var Vs=class extends hi{constructor(t,e,n){super(t,e,n)}};Vs.prototype.ValueTypeName="string";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=ia;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var vc=class extends hi{constructor(t,e,n,s){super(t,e,n,s)}};vc.prototype.ValueTypeName="vector";var Sc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let p=c[d],g=c[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Gg=new Sc,Mc=class{constructor(t){this.manager=t!==void 0?t:Gg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Mc.DEFAULT_MATERIAL_NAME="__DEFAULT";var xo=class extends xn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ee(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Sa=class extends xo{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(xn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ee(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Ju=new me,$m=new O,Zm=new O,bc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=Zn,this.map=null,this.mapPass=null,this.matrix=new me,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zi,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new Ce(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;$m.setFromMatrixPosition(t.matrixWorld),e.position.copy($m),Zm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Zm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Ju.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Ju,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===lo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Ju)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Vl=new O,Hl=new ai,qi=new O,ur=class extends xn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new me,this.projectionMatrix=new me,this.projectionMatrixInverse=new me,this.coordinateSystem=yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Vl,Hl,qi),qi.x===1&&qi.y===1&&qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Hl,qi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Vl,Hl,qi),qi.x===1&&qi.y===1&&qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Hl,qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Os=new O,Jm=new Zt,Km=new Zt,Hn=class extends ur{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ho*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ea*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ho*2*Math.atan(Math.tan(ea*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Os.x,Os.y).multiplyScalar(-t/Os.z),Os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Os.x,Os.y).multiplyScalar(-t/Os.z)}getViewSize(t,e){return this.getViewBounds(t,Jm,Km),e.subVectors(Km,Jm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ea*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Hs=class extends ur{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},ed=class extends bc{constructor(){super(new Hs(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ma=class extends xo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(xn.DEFAULT_UP),this.updateMatrix(),this.target=new xn,this.shadow=new ed}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},ba=class extends xo{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var so=-90,ro=1,yo=class extends xn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Hn(so,ro,t,e);s.layers=this.layers,this.add(s);let r=new Hn(so,ro,t,e);r.layers=this.layers,this.add(r);let o=new Hn(so,ro,t,e);o.layers=this.layers,this.add(o);let a=new Hn(so,ro,t,e);a.layers=this.layers,this.add(a);let l=new Hn(so,ro,t,e);l.layers=this.layers,this.add(l);let c=new Hn(so,ro,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===yi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===lo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,p),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},wc=class extends Hn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Fd="\\[\\]\\.:\\/",sv=new RegExp("["+Fd+"]","g"),Od="[^"+Fd+"]",rv="[^"+Fd.replace("\\.","")+"]",ov=/((?:WC+[\/:])*)/.source.replace("WC",Od),av=/(WCOD+)?/.source.replace("WCOD",rv),lv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Od),cv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Od),hv=new RegExp("^"+ov+av+lv+cv+"$"),uv=["material","materials","bones","map"],nd=class{constructor(t,e,n){let s=n||Ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ze=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(sv,"")}static parseTrackName(t){let e=hv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);uv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){se("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ce("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ce("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ce("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ce("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ce("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ce("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ze.Composite=nd;Ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ze.prototype.GetterByBindingType=[Ze.prototype._getValue_direct,Ze.prototype._getValue_array,Ze.prototype._getValue_arrayElement,Ze.prototype._getValue_toArray];Ze.prototype.SetterByBindingTypeAndVersioning=[[Ze.prototype._setValue_direct,Ze.prototype._setValue_direct_setNeedsUpdate,Ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_array,Ze.prototype._setValue_array_setNeedsUpdate,Ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_arrayElement,Ze.prototype._setValue_arrayElement_setNeedsUpdate,Ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_fromArray,Ze.prototype._setValue_fromArray_setNeedsUpdate,Ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var DT=new Float32Array(1);var jm=new me,wa=class{constructor(t,e,n=0,s=1/0){this.ray=new Bs(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new fo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ce("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return jm.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(jm),this}intersectObject(t,e=!0,n=[]){return id(t,this,n,e),n.sort(Qm),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)id(t[s],this,n,e);return n.sort(Qm),n}};function Qm(i,t){return i.distance-t.distance}function id(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)id(r[o],t,e,!0)}}var vo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ve(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var sd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}},tg=new Zt,So=class{constructor(t=new Zt(1/0,1/0),e=new Zt(-1/0,-1/0)){this.isBox2=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=tg.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=1/0,this.max.x=this.max.y=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y}getCenter(t){return this.isEmpty()?t.set(0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,tg).distanceTo(t)}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}};var Ea=class extends _o{constructor(t=10,e=10,n=4473924,s=8947848){n=new ee(n),s=new ee(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let u=0,p=0,g=-a;u<=e;u++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let S=u===r?n:s;S.toArray(c,p),p+=3,S.toArray(c,p),p+=3,S.toArray(c,p),p+=3,S.toArray(c,p),p+=3}let h=new Qe;h.setAttribute("position",new ze(l,3)),h.setAttribute("color",new ze(c,3));let d=new zs({vertexColors:!0,toneMapped:!1});super(h,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ta=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Bd(i,t,e,n){let s=dv(n);switch(e){case bd:return i*t;case Ed:return i*t/s.components*s.byteLength;case Lc:return i*t/s.components*s.byteLength;case Ys:return i*t*2/s.components*s.byteLength;case Dc:return i*t*2/s.components*s.byteLength;case wd:return i*t*3/s.components*s.byteLength;case Fi:return i*t*4/s.components*s.byteLength;case Nc:return i*t*4/s.components*s.byteLength;case Ra:case Pa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ia:case La:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Fc:case Bc:return Math.max(i,16)*Math.max(t,8)/4;case Uc:case Oc:return Math.max(i,8)*Math.max(t,8)/2;case zc:case kc:case Vc:case Hc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Gc:case Da:case Wc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case qc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Yc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case $c:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Zc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Jc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Kc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case jc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Qc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case th:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case eh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case nh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case ih:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case sh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case rh:case oh:case ah:return Math.ceil(i/4)*Math.ceil(t/4)*16;case lh:case ch:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Na:case hh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function dv(i){switch(i){case Zn:case yd:return{byteLength:1,components:1};case Eo:case vd:case Ui:return{byteLength:2,components:1};case Pc:case Ic:return{byteLength:2,components:4};case Di:case Rc:case Ni:return{byteLength:4,components:1};case Sd:case Md:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?se("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function c0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function xv(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((p,g)=>p.start-g.start);let u=0;for(let p=1;p<d.length;p++){let g=d[u],S=d[p];S.start<=g.start+g.count+1?g.count=Math.max(g.count,S.start+S.count-g.start):(++u,d[u]=S)}d.length=u+1;for(let p=0,g=d.length;p<g;p++){let S=d[p];i.bufferSubData(c,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var yv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,vv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Sv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Mv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,bv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,wv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ev=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Tv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Av=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Cv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Rv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Pv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Iv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Lv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Dv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Nv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Uv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Fv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ov=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Bv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,zv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Gv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Vv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Hv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Wv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Xv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,qv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Yv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,$v="gl_FragColor = linearToOutputTexel( gl_FragColor );",Zv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Jv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Kv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,jv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Qv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,tS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,eS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,nS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,iS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,sS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,rS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,oS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,aS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,cS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,hS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,uS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,dS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,fS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,pS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,mS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,gS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,_S=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,xS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,yS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,vS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,SS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,MS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ES=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,TS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,AS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,CS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,RS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,PS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,IS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,LS=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,DS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,NS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,US=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,FS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,OS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,BS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,GS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,VS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,HS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,WS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,XS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,qS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,YS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,$S=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ZS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,JS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,KS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,QS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,tM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,eM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,nM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,iM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,sM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,rM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,oM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,aM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,lM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,cM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,hM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,uM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,dM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,fM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,pM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,mM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,gM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,_M=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,xM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,yM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,SM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,EM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,TM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,AM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,CM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,RM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,IM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,LM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,DM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,NM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,UM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,OM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,zM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,kM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,GM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,HM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,XM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,YM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,$M=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ZM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,KM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,_e={alphahash_fragment:yv,alphahash_pars_fragment:vv,alphamap_fragment:Sv,alphamap_pars_fragment:Mv,alphatest_fragment:bv,alphatest_pars_fragment:wv,aomap_fragment:Ev,aomap_pars_fragment:Tv,batching_pars_vertex:Av,batching_vertex:Cv,begin_vertex:Rv,beginnormal_vertex:Pv,bsdfs:Iv,iridescence_fragment:Lv,bumpmap_pars_fragment:Dv,clipping_planes_fragment:Nv,clipping_planes_pars_fragment:Uv,clipping_planes_pars_vertex:Fv,clipping_planes_vertex:Ov,color_fragment:Bv,color_pars_fragment:zv,color_pars_vertex:kv,color_vertex:Gv,common:Vv,defaultnormal_vertex:Hv,displacementmap_pars_vertex:Wv,displacementmap_vertex:Xv,emissivemap_fragment:qv,emissivemap_pars_fragment:Yv,colorspace_fragment:$v,colorspace_pars_fragment:Zv,envmap_fragment:Jv,envmap_common_pars_fragment:Kv,envmap_pars_fragment:jv,envmap_pars_vertex:Qv,envmap_physical_pars_fragment:hS,envmap_vertex:tS,fog_vertex:eS,fog_pars_vertex:nS,fog_fragment:iS,fog_pars_fragment:sS,gradientmap_pars_fragment:rS,lightmap_pars_fragment:oS,lights_lambert_fragment:aS,lights_lambert_pars_fragment:lS,lights_pars_begin:cS,lights_toon_fragment:uS,lights_toon_pars_fragment:dS,lights_phong_fragment:fS,lights_phong_pars_fragment:pS,lights_physical_fragment:mS,lights_physical_pars_fragment:gS,lights_fragment_begin:_S,lights_fragment_maps:xS,lights_fragment_end:yS,lightprobes_pars_fragment:vS,logdepthbuf_fragment:SS,logdepthbuf_pars_fragment:MS,logdepthbuf_pars_vertex:bS,logdepthbuf_vertex:wS,map_fragment:ES,map_pars_fragment:TS,map_particle_fragment:AS,map_particle_pars_fragment:CS,metalnessmap_fragment:RS,metalnessmap_pars_fragment:PS,morphinstance_vertex:IS,morphcolor_vertex:LS,morphnormal_vertex:DS,morphtarget_pars_vertex:NS,morphtarget_vertex:US,normal_fragment_begin:FS,normal_fragment_maps:OS,normal_pars_fragment:BS,normal_pars_vertex:zS,normal_vertex:kS,normalmap_pars_fragment:GS,clearcoat_normal_fragment_begin:VS,clearcoat_normal_fragment_maps:HS,clearcoat_pars_fragment:WS,iridescence_pars_fragment:XS,opaque_fragment:qS,packing:YS,premultiplied_alpha_fragment:$S,project_vertex:ZS,dithering_fragment:JS,dithering_pars_fragment:KS,roughnessmap_fragment:jS,roughnessmap_pars_fragment:QS,shadowmap_pars_fragment:tM,shadowmap_pars_vertex:eM,shadowmap_vertex:nM,shadowmask_pars_fragment:iM,skinbase_vertex:sM,skinning_pars_vertex:rM,skinning_vertex:oM,skinnormal_vertex:aM,specularmap_fragment:lM,specularmap_pars_fragment:cM,tonemapping_fragment:hM,tonemapping_pars_fragment:uM,transmission_fragment:dM,transmission_pars_fragment:fM,uv_pars_fragment:pM,uv_pars_vertex:mM,uv_vertex:gM,worldpos_vertex:_M,background_vert:xM,background_frag:yM,backgroundCube_vert:vM,backgroundCube_frag:SM,cube_vert:MM,cube_frag:bM,depth_vert:wM,depth_frag:EM,distance_vert:TM,distance_frag:AM,equirect_vert:CM,equirect_frag:RM,linedashed_vert:PM,linedashed_frag:IM,meshbasic_vert:LM,meshbasic_frag:DM,meshlambert_vert:NM,meshlambert_frag:UM,meshmatcap_vert:FM,meshmatcap_frag:OM,meshnormal_vert:BM,meshnormal_frag:zM,meshphong_vert:kM,meshphong_frag:GM,meshphysical_vert:VM,meshphysical_frag:HM,meshtoon_vert:WM,meshtoon_frag:XM,points_vert:qM,points_frag:YM,shadow_vert:$M,shadow_frag:ZM,sprite_vert:JM,sprite_frag:KM},zt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},Qi={basic:{uniforms:Un([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.fog]),vertexShader:_e.meshbasic_vert,fragmentShader:_e.meshbasic_frag},lambert:{uniforms:Un([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:_e.meshlambert_vert,fragmentShader:_e.meshlambert_frag},phong:{uniforms:Un([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_e.meshphong_vert,fragmentShader:_e.meshphong_frag},standard:{uniforms:Un([zt.common,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.roughnessmap,zt.metalnessmap,zt.fog,zt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_e.meshphysical_vert,fragmentShader:_e.meshphysical_frag},toon:{uniforms:Un([zt.common,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.gradientmap,zt.fog,zt.lights,{emissive:{value:new ee(0)}}]),vertexShader:_e.meshtoon_vert,fragmentShader:_e.meshtoon_frag},matcap:{uniforms:Un([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,{matcap:{value:null}}]),vertexShader:_e.meshmatcap_vert,fragmentShader:_e.meshmatcap_frag},points:{uniforms:Un([zt.points,zt.fog]),vertexShader:_e.points_vert,fragmentShader:_e.points_frag},dashed:{uniforms:Un([zt.common,zt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_e.linedashed_vert,fragmentShader:_e.linedashed_frag},depth:{uniforms:Un([zt.common,zt.displacementmap]),vertexShader:_e.depth_vert,fragmentShader:_e.depth_frag},normal:{uniforms:Un([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,{opacity:{value:1}}]),vertexShader:_e.meshnormal_vert,fragmentShader:_e.meshnormal_frag},sprite:{uniforms:Un([zt.sprite,zt.fog]),vertexShader:_e.sprite_vert,fragmentShader:_e.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_e.background_vert,fragmentShader:_e.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:_e.backgroundCube_vert,fragmentShader:_e.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_e.cube_vert,fragmentShader:_e.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_e.equirect_vert,fragmentShader:_e.equirect_frag},distance:{uniforms:Un([zt.common,zt.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_e.distance_vert,fragmentShader:_e.distance_frag},shadow:{uniforms:Un([zt.lights,zt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:_e.shadow_vert,fragmentShader:_e.shadow_frag}};Qi.physical={uniforms:Un([Qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:_e.meshphysical_vert,fragmentShader:_e.meshphysical_frag};var ph={r:0,b:0,g:0},jM=new me,h0=new oe;h0.set(-1,0,0,0,1,0,0,0,1);function QM(i,t,e,n,s,r){let o=new ee(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function p(M){let R=M.isScene===!0?M.background:null;if(R&&R.isTexture){let v=M.backgroundBlurriness>0;R=t.get(R,v)}return R}function g(M){let R=!1,v=p(M);v===null?m(o,a):v&&v.isColor&&(m(v,1),R=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||R)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(M,R){let v=p(R);v&&v.isCubeTexture?(c===void 0&&(c=new an(new $n(1,1,1),new Ji({name:"BackgroundCubeMaterial",uniforms:gr(Qi.backgroundCube.uniforms),vertexShader:Qi.backgroundCube.vertexShader,fragmentShader:Qi.backgroundCube.fragmentShader,side:qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=R.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(jM.makeRotationFromEuler(R.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(h0),c.material.toneMapped=we.getTransfer(v.colorSpace)!==Ne,(h!==v||d!==v.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=v,d=v.version,u=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new an(new xa(2,2),new Ji({name:"BackgroundMaterial",uniforms:gr(Qi.background.uniforms),vertexShader:Qi.background.vertexShader,fragmentShader:Qi.background.fragmentShader,side:qs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,l.material.toneMapped=we.getTransfer(v.colorSpace)!==Ne,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||d!==v.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=v,d=v.version,u=i.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function m(M,R){M.getRGB(ph,Ud(i)),e.buffers.color.setClear(ph.r,ph.g,ph.b,R,r)}function f(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,R=1){o.set(M),a=R,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,m(o,a)},render:g,addToRenderList:S,dispose:f}}function tb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(D,z,W,L,V){let q=!1,H=d(D,L,W,z);r!==H&&(r=H,c(r.object)),q=p(D,L,W,V),q&&g(D,L,W,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,v(D,z,W,L),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,z,W,L){let V=L.wireframe===!0,q=n[z.id];q===void 0&&(q={},n[z.id]=q);let H=D.isInstancedMesh===!0?D.id:0,ct=q[H];ct===void 0&&(ct={},q[H]=ct);let Y=ct[W.id];Y===void 0&&(Y={},ct[W.id]=Y);let j=Y[V];return j===void 0&&(j=u(l()),Y[V]=j),j}function u(D){let z=[],W=[],L=[];for(let V=0;V<e;V++)z[V]=0,W[V]=0,L[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:L,object:D,attributes:{},index:null}}function p(D,z,W,L){let V=r.attributes,q=z.attributes,H=0,ct=W.getAttributes();for(let Y in ct)if(ct[Y].location>=0){let it=V[Y],pt=q[Y];if(pt===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(pt=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(pt=D.instanceColor)),it===void 0||it.attribute!==pt||pt&&it.data!==pt.data)return!0;H++}return r.attributesNum!==H||r.index!==L}function g(D,z,W,L){let V={},q=z.attributes,H=0,ct=W.getAttributes();for(let Y in ct)if(ct[Y].location>=0){let it=q[Y];it===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(it=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(it=D.instanceColor));let pt={};pt.attribute=it,it&&it.data&&(pt.data=it.data),V[Y]=pt,H++}r.attributes=V,r.attributesNum=H,r.index=L}function S(){let D=r.newAttributes;for(let z=0,W=D.length;z<W;z++)D[z]=0}function m(D){f(D,0)}function f(D,z){let W=r.newAttributes,L=r.enabledAttributes,V=r.attributeDivisors;W[D]=1,L[D]===0&&(i.enableVertexAttribArray(D),L[D]=1),V[D]!==z&&(i.vertexAttribDivisor(D,z),V[D]=z)}function M(){let D=r.newAttributes,z=r.enabledAttributes;for(let W=0,L=z.length;W<L;W++)z[W]!==D[W]&&(i.disableVertexAttribArray(W),z[W]=0)}function R(D,z,W,L,V,q,H){H===!0?i.vertexAttribIPointer(D,z,W,V,q):i.vertexAttribPointer(D,z,W,L,V,q)}function v(D,z,W,L){S();let V=L.attributes,q=W.getAttributes(),H=z.defaultAttributeValues;for(let ct in q){let Y=q[ct];if(Y.location>=0){let j=V[ct];if(j===void 0&&(ct==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),ct==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let it=j.normalized,pt=j.itemSize,ht=t.get(j);if(ht===void 0)continue;let tt=ht.buffer,gt=ht.type,Mt=ht.bytesPerElement,Lt=gt===i.INT||gt===i.UNSIGNED_INT||j.gpuType===Rc;if(j.isInterleavedBufferAttribute){let At=j.data,jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,he=j.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Jt=0;Jt<Y.locationSize;Jt++)f(Y.location+Jt,At.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Jt=0;Jt<Y.locationSize;Jt++)m(Y.location+Jt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Jt=0;Jt<Y.locationSize;Jt++)R(Y.location+Jt,pt/Y.locationSize,gt,it,jt*Mt,(he+pt/Y.locationSize*Jt)*Mt,Lt)}else{if(j.isInstancedBufferAttribute){for(let At=0;At<Y.locationSize;At++)f(Y.location+At,j.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let At=0;At<Y.locationSize;At++)m(Y.location+At);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let At=0;At<Y.locationSize;At++)R(Y.location+At,pt/Y.locationSize,gt,it,pt*Mt,pt/Y.locationSize*At*Mt,Lt)}}else if(H!==void 0){let it=H[ct];if(it!==void 0)switch(it.length){case 2:i.vertexAttrib2fv(Y.location,it);break;case 3:i.vertexAttrib3fv(Y.location,it);break;case 4:i.vertexAttrib4fv(Y.location,it);break;default:i.vertexAttrib1fv(Y.location,it)}}}}M()}function C(){B();for(let D in n){let z=n[D];for(let W in z){let L=z[W];for(let V in L){let q=L[V];for(let H in q)h(q[H].object),delete q[H];delete L[V]}}delete n[D]}}function A(D){if(n[D.id]===void 0)return;let z=n[D.id];for(let W in z){let L=z[W];for(let V in L){let q=L[V];for(let H in q)h(q[H].object),delete q[H];delete L[V]}}delete n[D.id]}function _(D){for(let z in n){let W=n[z];for(let L in W){let V=W[L];if(V[D.id]===void 0)continue;let q=V[D.id];for(let H in q)h(q[H].object),delete q[H];delete V[D.id]}}}function E(D){for(let z in n){let W=n[z],L=D.isInstancedMesh===!0?D.id:0,V=W[L];if(V!==void 0){for(let q in V){let H=V[q];for(let ct in H)h(H[ct].object),delete H[ct];delete V[q]}delete W[L],Object.keys(W).length===0&&delete n[z]}}}function B(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:_,initAttributes:S,enableAttribute:m,disableUnusedAttributes:M}}function eb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let p=0;p<h;p++)u+=c[p];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function nb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Fi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let E=_===Ui&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==Zn&&_!==Ni&&!E&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(se("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&se("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&se("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),R=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:g,maxTextureSize:S,maxCubemapSize:m,maxAttributes:f,maxVertexUniforms:M,maxVaryings:R,maxFragmentUniforms:v,maxSamples:C,samples:A}}function ib(i){let t=this,e=null,n=0,s=!1,r=!1,o=new oi,a=new oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let p=d.length!==0||u||n!==0||s;return s=u,n=d.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,p){let g=d.clippingPlanes,S=d.clipIntersection,m=d.clipShadows,f=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let M=r?0:n,R=M*4,v=f.clippingState||null;l.value=v,v=h(g,u,R,p);for(let C=0;C!==R;++C)v[C]=e[C];f.clippingState=v,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,p,g){let S=d!==null?d.length:0,m=null;if(S!==0){if(m=l.value,g!==!0||m===null){let f=p+S*4,M=u.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<f)&&(m=new Float32Array(f));for(let R=0,v=p;R!==S;++R,v+=4)o.copy(d[R]).applyMatrix4(M,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,m}}var Oa=class extends li{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new fa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new $n(5,5,5),r=new Ji({name:"CubemapFromEquirect",uniforms:gr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:qn,blending:dr});r.uniforms.tEquirect.value=e;let o=new an(s,r),a=e.minFilter;return e.minFilter===ys&&(e.minFilter=Wn),new yo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Vg=256,sb=3,rb=20,u0=256,d0=16,ob=3,ab=new O,lb=new ee,gh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new yo(1,10,null),this._boxMesh=new an(new $n(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=ab}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,S=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,S===null&&(t.background=l.getClearColor(lb));let m=new yo(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=g,t.background=S,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Xg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Wg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Vg,Ld(t))}_fromTexture(t,e){t.mapping===pr||t.mapping===wo?this._setSize(t.image.length===0?Vg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Hg(t,!1,!1),n=Math.log2(t)-sb;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Hg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===pr||t.mapping===wo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Xg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Wg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=cb(),this._integrationMaterial=hb());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/d0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-ob)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(u0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=ub());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Hg(i,t,e){return new Oa(i,{minFilter:ys,generateMipmaps:t,type:Ui,colorSpace:sa,depthBuffer:e})}function za(i,t,e){return new Ji({name:i,uniforms:t,vertexShader:_e.cube_vert,fragmentShader:e,side:qn,blending:dr,depthTest:!1,depthWrite:!1})}function cb(){return za("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${u0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function hb(){return za("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:d0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ub(){return za("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${rb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Wg(){return za("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Xg(){return za("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function db(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,p=!1){return u==null?null:p?o(u):r(u)}function r(u){if(u&&u.isTexture){let p=u.mapping;if(p===Tc||p===Ac)if(t.has(u)){let g=t.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let S=new Oa(g.height);return S.fromEquirectangularTexture(i,u),t.set(u,S),u.addEventListener("dispose",c),a(S.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,g=p===Tc||p===Ac,S=p===pr||p===wo;if(g||S){let m=e.get(u),f=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==f)return n===null&&(n=new gh(i)),m=g?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let M=u.image;return g&&M&&M.height>0||S&&M&&l(M)?(n===null&&(n=new gh(i)),m=g?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,p){return p===Tc?u.mapping=pr:p===Ac&&(u.mapping=wo),u}function l(u){let p=0,g=6;for(let S=0;S<g;S++)u[S]!==void 0&&p++;return p===g}function c(u){let p=u.target;p.removeEventListener("dispose",c);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function d(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function fb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ta("WebGLRenderer: "+n+" extension not supported."),s}}}function pb(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let S=r.get(g);S&&(t.remove(S),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,S){return s[S.id]!==void 0||(S.addEventListener("dispose",a),s[S.id]=new WeakRef(S),o.register(S,S.id,S),e.memory.geometries++),S}function h(g){let S=g.attributes;for(let m in S)t.update(S[m],i.ARRAY_BUFFER)}function d(g){let S=g.index,m=g.attributes.position,f=0;if(m===void 0)return;let M=S!==null?S.array.length:m.array.length/3-1,R=m.count>=65535?ua:ha,v=new R(Math.ceil(M/3)*6,1),C=v.array;if(S!==null){let _=S.array;f=S.version;for(let E=0,B=0;E<M;E+=3){let N=_[E+0],D=_[E+1],z=_[E+2];C[B++]=N,C[B++]=D,C[B++]=D,C[B++]=z,C[B++]=z,C[B++]=N}}else{f=m.version;for(let _=0,E=0;_<M;_+=3){let B=_+0,N=_+1,D=_+2;C[E++]=B,C[E++]=N,C[E++]=N,C[E++]=D,C[E++]=D,C[E++]=B}}v.version=f;let A=r.get(g);A&&t.remove(A),r.set(g,v)}function u(g){let S=r.get(g);if(S){let m=g.index;m!==null&&S.version<m.version&&d(g)}else d(g);return r.get(g)}function p(){for(let g in s){let S=s[g].deref();S!==void 0&&l(S)}}return{get:c,update:h,getWireframeAttribute:u,dispose:p}}function mb(i,t,e){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*o),e.update(u,n,1)}function c(d,u,p){p!==0&&(i.drawElementsInstanced(n,u,r,d*o,p),e.update(u,n,p))}function h(d,u,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,p);let S=0;for(let m=0;m<p;m++)S+=u[m];e.update(S,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function gb(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ce("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function _b(i,t,e){let n=new WeakMap,s=new Ce;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let B=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",B)};u!==void 0&&u.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,S=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],f=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],R=0;p===!0&&(R=1),g===!0&&(R=2),S===!0&&(R=3);let v=a.attributes.position.count*R,C=1;v>t.maxTextureSize&&(C=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*C*4*d),_=new la(A,v,C,d);_.type=Ni,_.needsUpdate=!0;let E=R*4;for(let N=0;N<d;N++){let D=m[N],z=f[N],W=M[N],L=v*C*4*N;for(let V=0;V<D.count;V++){let q=V*E;p===!0&&(s.fromBufferAttribute(D,V),A[L+q+0]=s.x,A[L+q+1]=s.y,A[L+q+2]=s.z,A[L+q+3]=0),g===!0&&(s.fromBufferAttribute(z,V),A[L+q+4]=s.x,A[L+q+5]=s.y,A[L+q+6]=s.z,A[L+q+7]=0),S===!0&&(s.fromBufferAttribute(W,V),A[L+q+8]=s.x,A[L+q+9]=s.y,A[L+q+10]=s.z,A[L+q+11]=W.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new Zt(v,C)},n.set(a,u),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let p=0;for(let S=0;S<c.length;S++)p+=c[S];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function xb(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var yb={[ud]:"LINEAR_TONE_MAPPING",[dd]:"REINHARD_TONE_MAPPING",[fd]:"CINEON_TONE_MAPPING",[pd]:"ACES_FILMIC_TONE_MAPPING",[gd]:"AGX_TONE_MAPPING",[_d]:"NEUTRAL_TONE_MAPPING",[md]:"CUSTOM_TONE_MAPPING"};function vb(i,t,e,n,s,r){let o=new li(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Qe;h.setAttribute("position",new ze([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ze([0,2,0,0,2,0],2));let d=new hc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new an(h,d),p=new Hs(-1,1,1,-1,0,1),g=null,S=null,m=!1,f,M=null,R=[],v=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<R.length;_++){let E=R[_];E.setSize&&E.setSize(C,A)}},this.setEffects=function(C){R=C,v=R.length>0&&R[0].isRenderPass===!0;let A=o.width,_=o.height;R.length>0&&a===null&&(a=new li(A,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}),l=new li(A,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&R.some(B=>B.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new xs(A,_),r===!0&&(c.format=vs,c.type=mr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let B=0;B<R.length;B++){let N=R[B];N.setSize&&N.setSize(A,_),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(C,A){if(m||C.toneMapping===Ki&&R.length===0)return!1;if(M=A,A!==null){let _=A.width,E=A.height;(o.width!==_||o.height!==E)&&this.setSize(_,E)}return v===!1&&C.setRenderTarget(o),f=C.toneMapping,C.toneMapping=Ki,!0},this.hasRenderPass=function(){return v},this.end=function(C,A){C.toneMapping=f,m=!0;let _=o,E=a;for(let B=0;B<R.length;B++){let N=R[B];N.enabled!==!1&&(N.render(C,E,_,A),N.needsSwap!==!1&&(_=E,E=E===a?l:a))}if(g!==C.outputColorSpace||S!==C.toneMapping){g=C.outputColorSpace,S=C.toneMapping,d.defines={},we.getTransfer(g)===Ne&&(d.defines.SRGB_TRANSFER="");let B=yb[S];B&&(d.defines[B]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(M),C.render(u,p),M=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var f0=new Xn,p0=new xs(1,1),m0=new ma(1),g0=new la,_0=new sc,x0=new fa,qg=[],Yg=[],$g=new Float32Array(16),Zg=new Float32Array(9),Jg=new Float32Array(4);function Ao(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=qg[s];if(r===void 0&&(r=new Float32Array(s),qg[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function yn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function vn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function _h(i,t){let e=Yg[t];e===void 0&&(e=new Int32Array(t),Yg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Sb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Mb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;i.uniform2fv(this.addr,t),vn(e,t)}}function bb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(yn(e,t))return;i.uniform3fv(this.addr,t),vn(e,t)}}function wb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;i.uniform4fv(this.addr,t),vn(e,t)}}function Eb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(yn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,n))return;Jg.set(n),i.uniformMatrix2fv(this.addr,!1,Jg),vn(e,n)}}function Tb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(yn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,n))return;Zg.set(n),i.uniformMatrix3fv(this.addr,!1,Zg),vn(e,n)}}function Ab(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(yn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,n))return;$g.set(n),i.uniformMatrix4fv(this.addr,!1,$g),vn(e,n)}}function Cb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Rb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;i.uniform2iv(this.addr,t),vn(e,t)}}function Pb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;i.uniform3iv(this.addr,t),vn(e,t)}}function Ib(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;i.uniform4iv(this.addr,t),vn(e,t)}}function Lb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Db(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;i.uniform2uiv(this.addr,t),vn(e,t)}}function Nb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;i.uniform3uiv(this.addr,t),vn(e,t)}}function Ub(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;i.uniform4uiv(this.addr,t),vn(e,t)}}function xh(i){return i.version===0&&(i.compareFunction=Cd,i.needsUpdate=!0),i}function Fb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=xh(p0):r=f0,e.setTexture2D(t||r,s)}function Ob(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||_0,s)}function Bb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=xh(m0):r=x0,e.setTextureCube(t||r,s)}function zb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||g0,s)}function kb(i){switch(i){case 5126:return Sb;case 35664:return Mb;case 35665:return bb;case 35666:return wb;case 35674:return Eb;case 35675:return Tb;case 35676:return Ab;case 5124:case 35670:return Cb;case 35667:case 35671:return Rb;case 35668:case 35672:return Pb;case 35669:case 35673:return Ib;case 5125:return Lb;case 36294:return Db;case 36295:return Nb;case 36296:return Ub;case 35678:case 36198:case 36298:case 36306:case 35682:return Fb;case 35679:case 36299:case 36307:return Ob;case 35680:case 36300:case 36308:case 36293:return Bb;case 36289:case 36303:case 36311:case 36292:return zb}}function Gb(i,t){i.uniform1fv(this.addr,t)}function Vb(i,t){let e=Ao(t,this.size,2);i.uniform2fv(this.addr,e)}function Hb(i,t){let e=Ao(t,this.size,3);i.uniform3fv(this.addr,e)}function Wb(i,t){let e=Ao(t,this.size,4);i.uniform4fv(this.addr,e)}function Xb(i,t){let e=Ao(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function qb(i,t){let e=Ao(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Yb(i,t){let e=Ao(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function $b(i,t){i.uniform1iv(this.addr,t)}function Zb(i,t){i.uniform2iv(this.addr,t)}function Jb(i,t){i.uniform3iv(this.addr,t)}function Kb(i,t){i.uniform4iv(this.addr,t)}function jb(i,t){i.uniform1uiv(this.addr,t)}function Qb(i,t){i.uniform2uiv(this.addr,t)}function tw(i,t){i.uniform3uiv(this.addr,t)}function ew(i,t){i.uniform4uiv(this.addr,t)}function nw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=xh(p0):o=f0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function iw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||_0,r[o])}function sw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=xh(m0):o=x0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function rw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||g0,r[o])}function ow(i){switch(i){case 5126:return Gb;case 35664:return Vb;case 35665:return Hb;case 35666:return Wb;case 35674:return Xb;case 35675:return qb;case 35676:return Yb;case 5124:case 35670:return $b;case 35667:case 35671:return Zb;case 35668:case 35672:return Jb;case 35669:case 35673:return Kb;case 5125:return jb;case 36294:return Qb;case 36295:return tw;case 36296:return ew;case 35678:case 36198:case 36298:case 36306:case 35682:return nw;case 35679:case 36299:case 36307:return iw;case 35680:case 36300:case 36308:case 36293:return sw;case 36289:case 36303:case 36311:case 36292:return rw}}var Gd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=kb(e.type)}},Vd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=ow(e.type)}},Hd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},zd=/(\w+)(\])?(\[|\.)?/g;function Kg(i,t){i.seq.push(t),i.map[t.id]=t}function aw(i,t,e){let n=i.name,s=n.length;for(zd.lastIndex=0;;){let r=zd.exec(n),o=zd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Kg(e,c===void 0?new Gd(a,i,t):new Vd(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new Hd(a),Kg(e,d)),e=d}}}var To=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);aw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function jg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var lw=37297,cw=0;function hw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Qg=new oe;function uw(i){we._getMatrix(Qg,we.workingColorSpace,i);let t=`mat3( ${Qg.elements.map(e=>e.toFixed(4))} )`;switch(we.getTransfer(i)){case ra:return[t,"LinearTransferOETF"];case Ne:return[t,"sRGBTransferOETF"];default:return se("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function t0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+hw(i.getShaderSource(t),a)}else return r}function dw(i,t){let e=uw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var fw={[ud]:"Linear",[dd]:"Reinhard",[fd]:"Cineon",[pd]:"ACESFilmic",[gd]:"AgX",[_d]:"Neutral",[md]:"Custom"};function pw(i,t){let e=fw[t];return e===void 0?(se("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var mh=new O;function mw(){we.getLuminanceCoefficients(mh);let i=mh.x.toFixed(4),t=mh.y.toFixed(4),e=mh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function gw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function _w(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function xw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Fa(i){return i!==""}function e0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function n0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var yw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wd(i){return i.replace(yw,vw)}function vw(i,t){let e=_e[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Wd(e)}var Sw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function i0(i){return i.replace(Sw,Mw)}function Mw(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function s0(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var bw={[Aa]:"SHADOWMAP_TYPE_PCF",[Mo]:"SHADOWMAP_TYPE_VSM"};function ww(i){return bw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Ew={[wo]:"ENVMAP_MODE_REFRACTION"};function Tw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Ew[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Aw={[Ec]:"ENVMAP_BLENDING_MULTIPLY",[Mg]:"ENVMAP_BLENDING_MIX",[bg]:"ENVMAP_BLENDING_ADD"};function Cw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Aw[i.combine]||"ENVMAP_BLENDING_NONE"}function Rw(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=ww(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Tw(e),d=Cw(e),u=gw(e),p=_w(r),g=s.createProgram(),S,m,f=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(S=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Fa).join(`
`),S.length>0&&(S+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Fa).join(`
`),m.length>0&&(m+=`
`)):(S=[s0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),m=[s0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ki?"#define TONE_MAPPING":"",e.toneMapping!==Ki?_e.tonemapping_pars_fragment:"",e.toneMapping!==Ki?pw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",_e.colorspace_pars_fragment,dw("linearToOutputTexel",e.outputColorSpace),mw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fa).join(`
`)),o=Wd(o),o=e0(o,e),o=n0(o,e),a=Wd(a),a=e0(a,e),a=n0(a,e),o=i0(o),a=i0(a),e.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,S=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,m=["#define varying in",e.glslVersion===Pd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Pd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let M=f+S+o,R=f+m+a,v=jg(s,s.VERTEX_SHADER,M),C=jg(s,s.FRAGMENT_SHADER,R);s.attachShader(g,v),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(N){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",z=s.getShaderInfoLog(v)||"",W=s.getShaderInfoLog(C)||"",L=D.trim(),V=z.trim(),q=W.trim(),H=!0,ct=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,v,C);else{let Y=t0(s,v,"vertex"),j=t0(s,C,"fragment");ce("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+L+`
`+Y+`
`+j)}else L!==""?se("WebGLProgram: Program Info Log:",L):(V===""||q==="")&&(ct=!1);ct&&(N.diagnostics={runnable:H,programLog:L,vertexShader:{log:V,prefix:S},fragmentShader:{log:q,prefix:m}})}s.deleteShader(v),s.deleteShader(C),_=new To(s,g),E=xw(s,g)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let B=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,lw)),B},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=cw++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=C,this}var Pw=0,Xd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new qd(t),e.set(t,n)),n}},qd=class{constructor(t){this.id=Pw++,this.code=t,this.usedTimes=0}};function Iw(i){return i===Ys||i===Da||i===Na}function Lw(i,t,e,n,s,r){let o=new fo,a=new Xd,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,E,B,N,D,z){let W=N.fog,L=D.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?N.environment:null,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=t.get(_.envMap||V,q),ct=u[_.type],Y=n.precision;_.precision!==null&&(Y=n.getMaxPrecision(_.precision),Y!==_.precision&&se("WebGLProgram.getParameters:",_.precision,"not supported, using",Y,"instead."));let j=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,it=j!==void 0?j.length:0,pt=0;L.morphAttributes.position!==void 0&&(pt=1),L.morphAttributes.normal!==void 0&&(pt=2),L.morphAttributes.color!==void 0&&(pt=3);let ht,tt,gt,Mt;if(ct){let Ct=Qi[ct];ht=Ct.vertexShader,tt=Ct.fragmentShader}else{ht=_.vertexShader,tt=_.fragmentShader;let Ct=a.getVertexShaderStage(_),ae=a.getFragmentShaderStage(_);a.update(_,Ct,ae),gt=Ct.id,Mt=ae.id}let Lt=i.getRenderTarget(),At=i.state.buffers.depth.getReversed(),jt=D.isInstancedMesh===!0,he=D.isBatchedMesh===!0,Jt=!!_.map,de=!!_.matcap,fe=!!H,re=fe&&H.isPMREMTexture===!0,Ue=!!_.aoMap,Le=!!_.lightMap,We=!!_.bumpMap&&_.wireframe===!1,K=!!_.normalMap,dt=!!_.displacementMap,xt=!!_.emissiveMap,bt=!!_.metalnessMap,_t=!!_.roughnessMap,Yt=_.anisotropy>0,P=_.clearcoat>0,ut=_.diffuseRoughness>0,kt=_.dispersion>0,Ut=_.retroreflectivity>0,yt=_.iridescence>0,Xt=_.sheen>0,Et=_.transmission>0,Gt=Yt&&!!_.anisotropyMap,T=P&&!!_.clearcoatMap,y=P&&!!_.clearcoatNormalMap,k=P&&!!_.clearcoatRoughnessMap,st=ut&&!!_.diffuseRoughnessMap,Q=yt&&!!_.iridescenceMap,mt=yt&&!!_.iridescenceThicknessMap,vt=Xt&&!!_.sheenColorMap,et=Xt&&!!_.sheenRoughnessMap,rt=!!_.specularMap,St=!!_.specularColorMap,F=!!_.specularIntensityMap,at=Et&&!!_.transmissionMap,ot=Et&&!!_.thicknessMap,Pt=!!_.gradientMap,Tt=!!_.alphaMap,Rt=_.alphaTest>0,Qt=!!_.alphaHash,ie=!!_.extensions,lt=Ki;_.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(lt=i.toneMapping);let Ot=re?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,te={shaderID:ct,shaderType:_.type,shaderName:_.name,vertexShader:ht,fragmentShader:tt,defines:_.defines,customVertexShaderID:gt,customFragmentShaderID:Mt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Y,batching:he,batchingColor:he&&D._colorsTexture!==null,instancing:jt,instancingColor:jt&&D.instanceColor!==null,instancingMorph:jt&&D.morphTexture!==null,outputColorSpace:Lt===null?i.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:we.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Jt,matcap:de,envMap:fe,envMapMode:fe&&H.mapping,envMapPMREM:re,envMapMaxLod:re?Ot.length-1:null,envMapSize:re?Ot[0].width:null,aoMap:Ue,lightMap:Le,bumpMap:We,normalMap:K,displacementMap:dt,emissiveMap:xt,normalMapObjectSpace:K&&_.normalMapType===Tg,normalMapTangentSpace:K&&_.normalMapType===uh,packedNormalMap:K&&_.normalMapType===uh&&Iw(_.normalMap.format),metalnessMap:bt,roughnessMap:_t,anisotropy:Yt,anisotropyMap:Gt,clearcoat:P,clearcoatMap:T,clearcoatNormalMap:y,clearcoatRoughnessMap:k,diffuseRoughness:ut,diffuseRoughnessMap:st,dispersion:kt,retroreflection:Ut,iridescence:yt,iridescenceMap:Q,iridescenceThicknessMap:mt,sheen:Xt,sheenColorMap:vt,sheenRoughnessMap:et,specularMap:rt,specularColorMap:St,specularIntensityMap:F,transmission:Et,transmissionMap:at,thicknessMap:ot,gradientMap:Pt,opaque:_.transparent===!1&&_.blending===bo&&_.alphaToCoverage===!1,alphaMap:Tt,alphaTest:Rt,alphaHash:Qt,combine:_.combine,mapUv:Jt&&p(_.map.channel),aoMapUv:Ue&&p(_.aoMap.channel),lightMapUv:Le&&p(_.lightMap.channel),bumpMapUv:We&&p(_.bumpMap.channel),normalMapUv:K&&p(_.normalMap.channel),displacementMapUv:dt&&p(_.displacementMap.channel),emissiveMapUv:xt&&p(_.emissiveMap.channel),metalnessMapUv:bt&&p(_.metalnessMap.channel),roughnessMapUv:_t&&p(_.roughnessMap.channel),anisotropyMapUv:Gt&&p(_.anisotropyMap.channel),clearcoatMapUv:T&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:k&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:st&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:mt&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:et&&p(_.sheenRoughnessMap.channel),specularMapUv:rt&&p(_.specularMap.channel),specularColorMapUv:St&&p(_.specularColorMap.channel),specularIntensityMapUv:F&&p(_.specularIntensityMap.channel),transmissionMapUv:at&&p(_.transmissionMap.channel),thicknessMapUv:ot&&p(_.thicknessMap.channel),alphaMapUv:Tt&&p(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(K||Yt),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Jt||Tt),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&K===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:At,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:pt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:z.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&B.length>0,shadowMapType:i.shadowMap.type,toneMapping:lt,decodeVideoTexture:Jt&&_.map.isVideoTexture===!0&&we.getTransfer(_.map.colorSpace)===Ne,decodeVideoTextureEmissive:xt&&_.emissiveMap.isVideoTexture===!0&&we.getTransfer(_.emissiveMap.colorSpace)===Ne,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Yn,flipSided:_.side===qn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ie&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ie&&_.extensions.multiDraw===!0||he)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function S(_){let E=[];if(_.shaderID?E.push(_.shaderID):(E.push(_.customVertexShaderID),E.push(_.customFragmentShaderID)),_.defines!==void 0)for(let B in _.defines)E.push(B),E.push(_.defines[B]);return _.isRawShaderMaterial===!1&&(m(E,_),f(E,_),E.push(i.outputColorSpace)),E.push(_.customProgramCacheKey),E.join()}function m(_,E){_.push(E.precision),_.push(E.outputColorSpace),_.push(E.envMapMode),_.push(E.envMapPMREM),_.push(E.envMapMaxLod),_.push(E.envMapSize),_.push(E.mapUv),_.push(E.alphaMapUv),_.push(E.lightMapUv),_.push(E.aoMapUv),_.push(E.bumpMapUv),_.push(E.normalMapUv),_.push(E.displacementMapUv),_.push(E.emissiveMapUv),_.push(E.metalnessMapUv),_.push(E.roughnessMapUv),_.push(E.anisotropyMapUv),_.push(E.clearcoatMapUv),_.push(E.clearcoatNormalMapUv),_.push(E.clearcoatRoughnessMapUv),_.push(E.diffuseRoughnessMapUv),_.push(E.iridescenceMapUv),_.push(E.iridescenceThicknessMapUv),_.push(E.sheenColorMapUv),_.push(E.sheenRoughnessMapUv),_.push(E.specularMapUv),_.push(E.specularColorMapUv),_.push(E.specularIntensityMapUv),_.push(E.transmissionMapUv),_.push(E.thicknessMapUv),_.push(E.combine),_.push(E.fogExp2),_.push(E.sizeAttenuation),_.push(E.morphTargetsCount),_.push(E.numSunLights),_.push(E.numDirLights),_.push(E.numPointLights),_.push(E.numSpotLights),_.push(E.numSpotLightMaps),_.push(E.numHemiLights),_.push(E.numRectAreaLights),_.push(E.numSunLightShadows),_.push(E.numDirLightShadows),_.push(E.numPointLightShadows),_.push(E.numSpotLightShadows),_.push(E.numSpotLightShadowsWithMaps),_.push(E.numLightProbes),_.push(E.numLightProbeGrids),_.push(E.shadowMapType),_.push(E.toneMapping),_.push(E.numClippingPlanes),_.push(E.numClipIntersection),_.push(E.depthPacking)}function f(_,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function M(_){let E=u[_.type],B;if(E){let N=Qi[E];B=zg.clone(N.uniforms)}else B=_.uniforms;return B}function R(_,E){let B=h.get(E);return B!==void 0?++B.usedTimes:(B=new Rw(i,E,_,s),c.push(B),h.set(E,B)),B}function v(_){if(--_.usedTimes===0){let E=c.indexOf(_);c[E]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:S,getUniforms:M,acquireProgram:R,releaseProgram:v,releaseShaderCache:C,programs:c,dispose:A}}function Dw(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Nw(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function r0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function o0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function a(u,p,g,S,m,f){let M=i[t];return M===void 0?(M={id:u.id,object:u,geometry:p,material:g,materialVariant:o(u),groupOrder:S,renderOrder:u.renderOrder,z:m,group:f},i[t]=M):(M.id=u.id,M.object=u,M.geometry=p,M.material=g,M.materialVariant=o(u),M.groupOrder=S,M.renderOrder=u.renderOrder,M.z=m,M.group=f),t++,M}function l(u,p,g,S,m,f,M){M.reversedDepth===!0&&(m=-m);let R=a(u,p,g,S,m,f);g.transmission>0?n.push(R):g.transparent===!0?s.push(R):e.push(R)}function c(u,p,g,S,m,f){let M=a(u,p,g,S,m,f);g.transmission>0?n.unshift(M):g.transparent===!0?s.unshift(M):e.unshift(M)}function h(u,p){e.length>1&&e.sort(u||Nw),n.length>1&&n.sort(p||r0),s.length>1&&s.sort(p||r0)}function d(){for(let u=t,p=i.length;u<p;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function Uw(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new o0,i.set(n,[o])):s>=r.length?(o=new o0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function Fw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new O,color:new ee};break;case"SpotLight":e={position:new O,direction:new O,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new O,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new O,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new O,halfWidth:new O,halfHeight:new O};break}return i[t.id]=e,e}}}function Ow(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Bw=0;function zw(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function kw(i){let t=new Fw,e=Ow(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new O);let s=new O,r=new me,o=new me;function a(c){let h=0,d=0,u=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let p=0,g=0,S=0,m=0,f=0,M=0,R=0,v=0,C=0,A=0,_=0,E=0,B=0,N=0;c.sort(zw);for(let z=0,W=c.length;z<W;z++){let L=c[z],V=L.color,q=L.intensity,H=L.distance,ct=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Ys?ct=L.shadow.map.texture:ct=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=V.r*q,d+=V.g*q,u+=V.b*q;else if(L.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(L.sh.coefficients[Y],q);N++}else if(L.isSunLight){let Y=t.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,it=e.get(L);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=it,n.sunShadowMap[g]=ct;let pt=j.getViewportCount();for(let ht=0;ht<pt;ht++)n.sunShadowMatrix[S+ht]=j.getMatrix(ht),n.sunShadowCascade[S+ht]=j._cascadeData[ht];S+=pt,g++}n.sun[p]=Y,p++}else if(L.isDirectionalLight){let Y=t.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,it=e.get(L);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize=j.mapSize,n.directionalShadow[m]=it,n.directionalShadowMap[m]=ct,n.directionalShadowMatrix[m]=L.shadow.matrix,C++}n.directional[m]=Y,m++}else if(L.isSpotLight){let Y=t.get(L);Y.position.setFromMatrixPosition(L.matrixWorld),Y.color.copy(V).multiplyScalar(q),Y.distance=H,Y.coneCos=Math.cos(L.angle),Y.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),Y.decay=L.decay,n.spot[M]=Y;let j=L.shadow;if(L.map&&(n.spotLightMap[E]=L.map,E++,j.updateMatrices(L),L.castShadow&&B++),n.spotLightMatrix[M]=j.matrix,L.castShadow){let it=e.get(L);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize=j.mapSize,n.spotShadow[M]=it,n.spotShadowMap[M]=ct,_++}M++}else if(L.isRectAreaLight){let Y=t.get(L);Y.color.copy(V).multiplyScalar(q),Y.halfWidth.set(L.width*.5,0,0),Y.halfHeight.set(0,L.height*.5,0),n.rectArea[R]=Y,R++}else if(L.isPointLight){let Y=t.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),Y.distance=L.distance,Y.decay=L.decay,L.castShadow){let j=L.shadow,it=e.get(L);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize=j.mapSize,it.shadowCameraNear=j.camera.near,it.shadowCameraFar=j.camera.far,n.pointShadow[f]=it,n.pointShadowMap[f]=ct,n.pointShadowMatrix[f]=L.shadow.matrix,A++}n.point[f]=Y,f++}else if(L.isHemisphereLight){let Y=t.get(L);Y.skyColor.copy(L.color).multiplyScalar(q),Y.groundColor.copy(L.groundColor).multiplyScalar(q),n.hemi[v]=Y,v++}}R>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=zt.LTC_FLOAT_1,n.rectAreaLTC2=zt.LTC_FLOAT_2):(n.rectAreaLTC1=zt.LTC_HALF_1,n.rectAreaLTC2=zt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==p||D.directionalLength!==m||D.pointLength!==f||D.spotLength!==M||D.rectAreaLength!==R||D.hemiLength!==v||D.numSunShadows!==g||D.numDirectionalShadows!==C||D.numPointShadows!==A||D.numSpotShadows!==_||D.numSpotMaps!==E||D.numLightProbes!==N)&&(n.sun.length=p,n.directional.length=m,n.spot.length=M,n.rectArea.length=R,n.point.length=f,n.hemi.length=v,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+E-B,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=B,n.numLightProbes=N,D.sunLength=p,D.directionalLength=m,D.pointLength=f,D.spotLength=M,D.rectAreaLength=R,D.hemiLength=v,D.numSunShadows=g,D.numDirectionalShadows=C,D.numPointShadows=A,D.numSpotShadows=_,D.numSpotMaps=E,D.numLightProbes=N,n.version=Bw++)}function l(c,h){let d=0,u=0,p=0,g=0,S=0,m=0,f=h.matrixWorldInverse;for(let M=0,R=c.length;M<R;M++){let v=c[M];if(v.isSunLight){let C=n.sun[d];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(f),d++}else if(v.isDirectionalLight){let C=n.directional[u];C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(f),u++}else if(v.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(f),C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(f),g++}else if(v.isRectAreaLight){let C=n.rectArea[S];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(f),o.identity(),r.copy(v.matrixWorld),r.premultiply(f),o.extractRotation(r),C.halfWidth.set(v.width*.5,0,0),C.halfHeight.set(0,v.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),S++}else if(v.isPointLight){let C=n.point[p];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(f),p++}else if(v.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(f),m++}}}return{setup:a,setupView:l,state:n}}function a0(i){let t=new kw(i),e=[],n=[],s=[];function r(d){h.camera=d,e.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){n.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Gw(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new a0(i),t.set(s,[a])):r>=o.length?(a=new a0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var Vw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Hw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Ww=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],Xw=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],l0=new me,Ua=new O,kd=new O;function qw(i,t,e){let n=new Zi,s=new Zt,r=new Zt,o=new Ce,a=new uc,l=new dc,c={},h=e.maxTextureSize,d={[qs]:qn,[qn]:qs,[Yn]:Yn},u=new Ji({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:Vw,fragmentShader:Hw}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let g=new Qe;g.setAttribute("position",new An(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new an(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Aa;let f=this.type;this.render=function(A,_,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===ig&&(se("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Aa);let B=i.getRenderTarget(),N=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),z=i.state;z.setBlending(dr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=f!==this.type;W&&_.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(V=>V.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,V=A.length;L<V;L++){let q=A[L],H=q.shadow;if(H===void 0){se("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ct=H.getFrameExtents();s.multiply(ct),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,H.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||W===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Mo){if(q.isPointLight){se("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new li(s.x,s.y,{format:Ys,type:Ui,minFilter:Wn,magFilter:Wn,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new xs(s.x,s.y,Ni),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=ps,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Cn,H.map.depthTexture.magFilter=Cn}else q.isPointLight?(H.map=new Oa(s.x),H.map.depthTexture=new ma(s.x,Di)):(H.map=new li(s.x,s.y),H.map.depthTexture=new xs(s.x,s.y,Di)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=ps,this.type===Aa?(H.map.depthTexture.compareFunction=Y?Ad:Td,H.map.depthTexture.minFilter=Wn,H.map.depthTexture.magFilter=Wn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Cn,H.map.depthTexture.magFilter=Cn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let j=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,E);let it=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let pt=0;pt<j;pt++){let ht=H.getCamera(pt);if(q.isPointLight){let tt=H.camera,gt=H.matrix,Mt=q.distance||tt.far;Mt!==tt.far&&(tt.far=Mt,tt.updateProjectionMatrix()),Ua.setFromMatrixPosition(q.matrixWorld),tt.position.copy(Ua),kd.copy(tt.position),kd.add(Ww[pt]),tt.up.copy(Xw[pt]),tt.lookAt(kd),tt.updateMatrixWorld(),gt.makeTranslation(-Ua.x,-Ua.y,-Ua.z),l0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(l0,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,pt),i.clear();else{pt===0&&(i.setRenderTarget(H.map),i.clear());let tt=H.getViewport(pt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),z.viewport(o)}n=H.getFrustum(pt),v(_,E,ht,q,it,this.type)}H.isPointLightShadow!==!0&&this.type===Mo&&M(H,E),H.needsUpdate=!1}f=this.type,m.needsUpdate=!1,i.setRenderTarget(B,N,D)};function M(A,_){let E=t.update(S);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new li(s.x,s.y,{format:Ys,type:Ui}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(_,null,E,u,S,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(_,null,E,p,S,null)}function R(A,_,E,B){let N=null,D=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(D!==void 0)N=D;else if(N=E.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let z=N.uuid,W=_.uuid,L=c[z];L===void 0&&(L={},c[z]=L);let V=L[W];V===void 0&&(V=N.clone(),L[W]=V,_.addEventListener("dispose",C)),N=V}if(N.visible=_.visible,N.wireframe=_.wireframe,B===Mo?N.side=_.shadowSide!==null?_.shadowSide:_.side:N.side=_.shadowSide!==null?_.shadowSide:d[_.side],N.alphaMap=_.alphaMap,N.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,N.map=_.map,N.clipShadows=_.clipShadows,N.clippingPlanes=_.clippingPlanes,N.clipIntersection=_.clipIntersection,N.displacementMap=_.displacementMap,N.displacementScale=_.displacementScale,N.displacementBias=_.displacementBias,N.wireframeLinewidth=_.wireframeLinewidth,N.linewidth=_.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let z=i.properties.get(N);z.light=E}return N}function v(A,_,E,B,N,D){if(A.visible===!1)return;if(A.layers.test(N)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&D===Mo)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let L=t.update(A),V=A.material;if(Array.isArray(V)){let q=L.groups;for(let H=0,ct=q.length;H<ct;H++){let Y=q[H],j=V[Y.materialIndex];if(j&&j.visible){let it=R(A,j,B,D);A.onBeforeShadow(i,A,_,E,L,it,Y),i.renderBufferDirect(E,null,L,it,A,Y),A.onAfterShadow(i,A,_,E,L,it,Y)}}}else if(V.visible){let q=R(A,V,B,D);A.onBeforeShadow(i,A,_,E,L,q,null),i.renderBufferDirect(E,null,L,q,A,null),A.onAfterShadow(i,A,_,E,L,q,null)}}let W=A.children;for(let L=0,V=W.length;L<V;L++)v(W[L],_,E,B,N,D)}function C(A){A.target.removeEventListener("dispose",C);for(let E in c){let B=c[E],N=A.target.uuid;N in B&&(B[N].dispose(),delete B[N])}}}function Yw(i,t){function e(){let F=!1,at=new Ce,ot=null,Pt=new Ce(0,0,0,0);return{setMask:function(Tt){ot!==Tt&&!F&&(i.colorMask(Tt,Tt,Tt,Tt),ot=Tt)},setLocked:function(Tt){F=Tt},setClear:function(Tt,Rt,Qt,ie,lt){lt===!0&&(Tt*=ie,Rt*=ie,Qt*=ie),at.set(Tt,Rt,Qt,ie),Pt.equals(at)===!1&&(i.clearColor(Tt,Rt,Qt,ie),Pt.copy(at))},reset:function(){F=!1,ot=null,Pt.set(-1,0,0,0)}}}function n(){let F=!1,at=!1,ot=null,Pt=null,Tt=null;return{setReversed:function(Rt){if(at!==Rt){let Qt=t.get("EXT_clip_control");Rt?Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.ZERO_TO_ONE_EXT):Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.NEGATIVE_ONE_TO_ONE_EXT),at=Rt;let ie=Tt;Tt=null,this.setClear(ie)}},getReversed:function(){return at},setTest:function(Rt){Rt?At(i.DEPTH_TEST):jt(i.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!F&&(i.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(at&&(Rt=Fg[Rt]),Pt!==Rt){switch(Rt){case ql:i.depthFunc(i.NEVER);break;case Yl:i.depthFunc(i.ALWAYS);break;case $l:i.depthFunc(i.LESS);break;case ao:i.depthFunc(i.LEQUAL);break;case Zl:i.depthFunc(i.EQUAL);break;case Jl:i.depthFunc(i.GEQUAL);break;case Kl:i.depthFunc(i.GREATER);break;case jl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Pt=Rt}},setLocked:function(Rt){F=Rt},setClear:function(Rt){Tt!==Rt&&(Tt=Rt,at&&(Rt=1-Rt),i.clearDepth(Rt))},reset:function(){F=!1,ot=null,Pt=null,Tt=null,at=!1}}}function s(){let F=!1,at=null,ot=null,Pt=null,Tt=null,Rt=null,Qt=null,ie=null,lt=null;return{setTest:function(Ot){F||(Ot?At(i.STENCIL_TEST):jt(i.STENCIL_TEST))},setMask:function(Ot){at!==Ot&&!F&&(i.stencilMask(Ot),at=Ot)},setFunc:function(Ot,te,Ct){(ot!==Ot||Pt!==te||Tt!==Ct)&&(i.stencilFunc(Ot,te,Ct),ot=Ot,Pt=te,Tt=Ct)},setOp:function(Ot,te,Ct){(Rt!==Ot||Qt!==te||ie!==Ct)&&(i.stencilOp(Ot,te,Ct),Rt=Ot,Qt=te,ie=Ct)},setLocked:function(Ot){F=Ot},setClear:function(Ot){lt!==Ot&&(i.clearStencil(Ot),lt=Ot)},reset:function(){F=!1,at=null,ot=null,Pt=null,Tt=null,Rt=null,Qt=null,ie=null,lt=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},d={},u={},p=new WeakMap,g=[],S=null,m=!1,f=null,M=null,R=null,v=null,C=null,A=null,_=null,E=new ee(0,0,0),B=0,N=!1,D=null,z=null,W=null,L=null,V=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ct=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=ct>=1):Y.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=ct>=2);let j=null,it={},pt=i.getParameter(i.SCISSOR_BOX),ht=i.getParameter(i.VIEWPORT),tt=new Ce().fromArray(pt),gt=new Ce().fromArray(ht);function Mt(F,at,ot,Pt){let Tt=new Uint8Array(4),Rt=i.createTexture();i.bindTexture(F,Rt),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qt=0;Qt<ot;Qt++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(at,0,i.RGBA,1,1,Pt,0,i.RGBA,i.UNSIGNED_BYTE,Tt):i.texImage2D(at+Qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Tt);return Rt}let Lt={};Lt[i.TEXTURE_2D]=Mt(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=Mt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=Mt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=Mt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(i.DEPTH_TEST),o.setFunc(ao),We(!1),K(rd),At(i.CULL_FACE),Ue(dr);function At(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function jt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function he(F,at){return u[F]!==at?(i.bindFramebuffer(F,at),u[F]=at,F===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=at),F===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=at),!0):!1}function Jt(F,at){let ot=g,Pt=!1;if(F){ot=p.get(at),ot===void 0&&(ot=[],p.set(at,ot));let Tt=F.textures;if(ot.length!==Tt.length||ot[0]!==i.COLOR_ATTACHMENT0){for(let Rt=0,Qt=Tt.length;Rt<Qt;Rt++)ot[Rt]=i.COLOR_ATTACHMENT0+Rt;ot.length=Tt.length,Pt=!0}}else ot[0]!==i.BACK&&(ot[0]=i.BACK,Pt=!0);Pt&&i.drawBuffers(ot)}function de(F){return S!==F?(i.useProgram(F),S=F,!0):!1}let fe={[fr]:i.FUNC_ADD,[rg]:i.FUNC_SUBTRACT,[og]:i.FUNC_REVERSE_SUBTRACT};fe[ag]=i.MIN,fe[lg]=i.MAX;let re={[cg]:i.ZERO,[hg]:i.ONE,[ug]:i.SRC_COLOR,[cd]:i.SRC_ALPHA,[_g]:i.SRC_ALPHA_SATURATE,[mg]:i.DST_COLOR,[fg]:i.DST_ALPHA,[dg]:i.ONE_MINUS_SRC_COLOR,[hd]:i.ONE_MINUS_SRC_ALPHA,[gg]:i.ONE_MINUS_DST_COLOR,[pg]:i.ONE_MINUS_DST_ALPHA,[xg]:i.CONSTANT_COLOR,[yg]:i.ONE_MINUS_CONSTANT_COLOR,[vg]:i.CONSTANT_ALPHA,[Sg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ue(F,at,ot,Pt,Tt,Rt,Qt,ie,lt,Ot){if(F===dr){m===!0&&(jt(i.BLEND),m=!1);return}if(m===!1&&(At(i.BLEND),m=!0),F!==sg){if(F!==f||Ot!==N){if((M!==fr||C!==fr)&&(i.blendEquation(i.FUNC_ADD),M=fr,C=fr),Ot)switch(F){case bo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case od:i.blendFunc(i.ONE,i.ONE);break;case ad:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ld:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ce("WebGLState: Invalid blending: ",F);break}else switch(F){case bo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case od:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ad:ce("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ld:ce("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ce("WebGLState: Invalid blending: ",F);break}R=null,v=null,A=null,_=null,E.set(0,0,0),B=0,f=F,N=Ot}return}Tt=Tt||at,Rt=Rt||ot,Qt=Qt||Pt,(at!==M||Tt!==C)&&(i.blendEquationSeparate(fe[at],fe[Tt]),M=at,C=Tt),(ot!==R||Pt!==v||Rt!==A||Qt!==_)&&(i.blendFuncSeparate(re[ot],re[Pt],re[Rt],re[Qt]),R=ot,v=Pt,A=Rt,_=Qt),(ie.equals(E)===!1||lt!==B)&&(i.blendColor(ie.r,ie.g,ie.b,lt),E.copy(ie),B=lt),f=F,N=!1}function Le(F,at){F.side===Yn?jt(i.CULL_FACE):At(i.CULL_FACE);let ot=F.side===qn;at&&(ot=!ot),We(ot),F.blending===bo&&F.transparent===!1?Ue(dr):Ue(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Pt=F.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),xt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?At(i.SAMPLE_ALPHA_TO_COVERAGE):jt(i.SAMPLE_ALPHA_TO_COVERAGE)}function We(F){D!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),D=F)}function K(F){F!==eg?(At(i.CULL_FACE),F!==z&&(F===rd?i.cullFace(i.BACK):F===ng?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):jt(i.CULL_FACE),z=F}function dt(F){F!==W&&(H&&i.lineWidth(F),W=F)}function xt(F,at,ot){F?(At(i.POLYGON_OFFSET_FILL),(L!==at||V!==ot)&&(L=at,V=ot,o.getReversed()&&(at=-at,ot=-ot),i.polygonOffset(at,ot))):jt(i.POLYGON_OFFSET_FILL)}function bt(F){F?At(i.SCISSOR_TEST):jt(i.SCISSOR_TEST)}function _t(F){F===void 0&&(F=i.TEXTURE0+q-1),j!==F&&(i.activeTexture(F),j=F)}function Yt(F,at,ot){ot===void 0&&(j===null?ot=i.TEXTURE0+q-1:ot=j);let Pt=it[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},it[ot]=Pt),(Pt.type!==F||Pt.texture!==at)&&(j!==ot&&(i.activeTexture(ot),j=ot),i.bindTexture(F,at||Lt[F]),Pt.type=F,Pt.texture=at)}function P(){let F=it[j];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function ut(){try{i.compressedTexImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function kt(){try{i.compressedTexImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function yt(){try{i.texSubImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function Xt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function Et(){try{i.compressedTexSubImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function Gt(){try{i.texStorage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function T(){try{i.texStorage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function y(){try{i.texImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function k(){try{i.texImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function st(F){return d[F]!==void 0?d[F]:i.getParameter(F)}function Q(F,at){d[F]!==at&&(i.pixelStorei(F,at),d[F]=at)}function mt(F){tt.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function vt(F){gt.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),gt.copy(F))}function et(F,at){let ot=c.get(at);ot===void 0&&(ot=new WeakMap,c.set(at,ot));let Pt=ot.get(F);Pt===void 0&&(Pt=i.getUniformBlockIndex(at,F.name),i.uniformBlockBinding(at,Pt,Pt),ot.set(F,Pt))}function rt(F,at,ot){let Tt=c.get(at).get(F);l[Tt]!==ot&&(i.bindBufferBase(i.UNIFORM_BUFFER,Tt,ot),l[Tt]=ot)}function St(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},j=null,it={},u={},l={},p=new WeakMap,g=[],S=null,m=!1,f=null,M=null,R=null,v=null,C=null,A=null,_=null,E=new ee(0,0,0),B=0,N=!1,D=null,z=null,W=null,L=null,V=null,tt.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:jt,bindFramebuffer:he,drawBuffers:Jt,useProgram:de,setBlending:Ue,setMaterial:Le,setFlipSided:We,setCullFace:K,setLineWidth:dt,setPolygonOffset:xt,setScissorTest:bt,activeTexture:_t,bindTexture:Yt,unbindTexture:P,compressedTexImage2D:ut,compressedTexImage3D:kt,texImage2D:y,texImage3D:k,pixelStorei:Q,getParameter:st,updateUBOMapping:et,uniformBlockBinding:rt,texStorage2D:Gt,texStorage3D:T,texSubImage2D:Ut,texSubImage3D:yt,compressedTexSubImage2D:Xt,compressedTexSubImage3D:Et,scissor:mt,viewport:vt,reset:St}}function $w(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,h=new WeakMap,d=new Set,u,p=new WeakMap,g=new Set,S=new FinalizationRegistry(T=>g.delete(T)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(T,y){return m?new OffscreenCanvas(T,y):oa("canvas")}function M(T,y,k){let st=1,Q=Gt(T);if((Q.width>k||Q.height>k)&&(st=k/Math.max(Q.width,Q.height)),st<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let mt=Math.floor(st*Q.width),vt=Math.floor(st*Q.height);u===void 0&&(u=f(mt,vt));let et=y?f(mt,vt):u;return et.width=mt,et.height=vt,et.getContext("2d").drawImage(T,0,0,mt,vt),se("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+mt+"x"+vt+")."),et}else return"data"in T&&se("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),T;return T}function R(T){return T.generateMipmaps}function v(T){i.generateMipmap(T)}function C(T){return T.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?i.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(T,y,k,st,Q,mt=!1){if(T!==null){if(i[T]!==void 0)return i[T];se("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let vt;st&&(vt=t.get("EXT_texture_norm16"),vt||se("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=y;if(y===i.RED&&(k===i.FLOAT&&(et=i.R32F),k===i.HALF_FLOAT&&(et=i.R16F),k===i.UNSIGNED_BYTE&&(et=i.R8),k===i.UNSIGNED_SHORT&&vt&&(et=vt.R16_EXT),k===i.SHORT&&vt&&(et=vt.R16_SNORM_EXT)),y===i.RED_INTEGER&&(k===i.UNSIGNED_BYTE&&(et=i.R8UI),k===i.UNSIGNED_SHORT&&(et=i.R16UI),k===i.UNSIGNED_INT&&(et=i.R32UI),k===i.BYTE&&(et=i.R8I),k===i.SHORT&&(et=i.R16I),k===i.INT&&(et=i.R32I)),y===i.RG&&(k===i.FLOAT&&(et=i.RG32F),k===i.HALF_FLOAT&&(et=i.RG16F),k===i.UNSIGNED_BYTE&&(et=i.RG8),k===i.UNSIGNED_SHORT&&vt&&(et=vt.RG16_EXT),k===i.SHORT&&vt&&(et=vt.RG16_SNORM_EXT)),y===i.RG_INTEGER&&(k===i.UNSIGNED_BYTE&&(et=i.RG8UI),k===i.UNSIGNED_SHORT&&(et=i.RG16UI),k===i.UNSIGNED_INT&&(et=i.RG32UI),k===i.BYTE&&(et=i.RG8I),k===i.SHORT&&(et=i.RG16I),k===i.INT&&(et=i.RG32I)),y===i.RGB_INTEGER&&(k===i.UNSIGNED_BYTE&&(et=i.RGB8UI),k===i.UNSIGNED_SHORT&&(et=i.RGB16UI),k===i.UNSIGNED_INT&&(et=i.RGB32UI),k===i.BYTE&&(et=i.RGB8I),k===i.SHORT&&(et=i.RGB16I),k===i.INT&&(et=i.RGB32I)),y===i.RGBA_INTEGER&&(k===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),k===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),k===i.UNSIGNED_INT&&(et=i.RGBA32UI),k===i.BYTE&&(et=i.RGBA8I),k===i.SHORT&&(et=i.RGBA16I),k===i.INT&&(et=i.RGBA32I)),y===i.RGB&&(k===i.UNSIGNED_SHORT&&vt&&(et=vt.RGB16_EXT),k===i.SHORT&&vt&&(et=vt.RGB16_SNORM_EXT),k===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),k===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),y===i.RGBA){let rt=mt?ra:we.getTransfer(Q);k===i.FLOAT&&(et=i.RGBA32F),k===i.HALF_FLOAT&&(et=i.RGBA16F),k===i.UNSIGNED_BYTE&&(et=rt===Ne?i.SRGB8_ALPHA8:i.RGBA8),k===i.UNSIGNED_SHORT&&vt&&(et=vt.RGBA16_EXT),k===i.SHORT&&vt&&(et=vt.RGBA16_SNORM_EXT),k===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),k===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function _(T,y){let k;return T?y===null||y===Di||y===mr?k=i.DEPTH24_STENCIL8:y===Ni?k=i.DEPTH32F_STENCIL8:y===Eo&&(k=i.DEPTH24_STENCIL8,se("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Di||y===mr?k=i.DEPTH_COMPONENT24:y===Ni?k=i.DEPTH_COMPONENT32F:y===Eo&&(k=i.DEPTH_COMPONENT16),k}function E(T,y){return R(T)===!0||T.isFramebufferTexture&&T.minFilter!==Cn&&T.minFilter!==Wn?Math.log2(Math.max(y.width,y.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?y.mipmaps.length:1}function B(T){let y=new WeakRef(T);n.get(T).__ref=y,g.add(y),S.register(T,y,y)}function N(T){let y=n.get(T).__ref;y!==void 0&&(g.delete(y),S.unregister(y))}function D(T){W(T.target)}function z(T){L(T.target)}function W(T){T.removeEventListener("dispose",D),N(T),q(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&d.delete(T)}function L(T){T.removeEventListener("dispose",z),N(T),ct(T)}function V(){for(let T of g){let y=T.deref();y!==void 0&&(y.isRenderTarget===!0?L(y):W(y))}g.clear(),d.clear()}function q(T){let y=n.get(T);if(y.__webglInit===void 0)return;let k=T.source,st=p.get(k);if(st){let Q=st[y.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&H(T),Object.keys(st).length===0&&p.delete(k)}n.remove(T)}function H(T){let y=n.get(T);i.deleteTexture(y.__webglTexture);let k=T.source,st=p.get(k);delete st[y.__cacheKey],o.memory.textures--}function ct(T){let y=n.get(T);y.__depthDisposeCallback&&y.__depthDisposeCallback();let k=T.depthTexture;if(k&&k.renderTarget===T&&W(k),T.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(y.__webglFramebuffer[Q]))for(let mt=0;mt<y.__webglFramebuffer[Q].length;mt++)i.deleteFramebuffer(y.__webglFramebuffer[Q][mt]);else i.deleteFramebuffer(y.__webglFramebuffer[Q]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[Q])}else{if(Array.isArray(y.__webglFramebuffer))for(let Q=0;Q<y.__webglFramebuffer.length;Q++)i.deleteFramebuffer(y.__webglFramebuffer[Q]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Q=0;Q<y.__webglColorRenderbuffer.length;Q++)y.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[Q]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let st=T.textures;for(let Q=0,mt=st.length;Q<mt;Q++){let vt=n.get(st[Q]);vt.__webglTexture&&(i.deleteTexture(vt.__webglTexture),o.memory.textures--),n.remove(st[Q])}n.remove(T)}let Y=0;function j(){Y=0}function it(){return Y}function pt(T){Y=T}function ht(){let T=Y;return T>=s.maxTextures&&se("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,T}function tt(T){let y=[];return y.push(T.wrapS),y.push(T.wrapT),y.push(T.wrapR||0),y.push(T.magFilter),y.push(T.minFilter),y.push(T.anisotropy),y.push(T.internalFormat),y.push(T.format),y.push(T.type),y.push(T.generateMipmaps),y.push(T.mipmapsAutoUpdate),y.push(T.premultiplyAlpha),y.push(T.flipY),y.push(T.unpackAlignment),y.push(T.colorSpace),y.join()}function gt(T,y){let k=n.get(T);if(T.isVideoTexture&&Xt(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&k.__version!==T.version){let st=T.image;if(st===null)se("WebGLRenderer: Texture marked for update but no image data found.");else if(st.complete===!1)se("WebGLRenderer: Texture marked for update but image is incomplete");else{Le(k,T,y);return}}else T.isExternalTexture&&(k.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,k.__webglTexture,i.TEXTURE0+y)}function Mt(T,y){let k=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&k.__version!==T.version){Le(k,T,y);return}else T.isExternalTexture&&(k.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,k.__webglTexture,i.TEXTURE0+y)}function Lt(T,y){let k=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&k.__version!==T.version){Le(k,T,y);return}e.bindTexture(i.TEXTURE_3D,k.__webglTexture,i.TEXTURE0+y)}function At(T,y){let k=n.get(T);if(T.version>0&&k.__version!==T.version){We(k,T,y);return}e.bindTexture(i.TEXTURE_CUBE_MAP,k.__webglTexture,i.TEXTURE0+y)}let jt={[Ql]:i.REPEAT,[Yi]:i.CLAMP_TO_EDGE,[tc]:i.MIRRORED_REPEAT},he={[Cn]:i.NEAREST,[wg]:i.NEAREST_MIPMAP_NEAREST,[Ca]:i.NEAREST_MIPMAP_LINEAR,[Wn]:i.LINEAR,[Cc]:i.LINEAR_MIPMAP_NEAREST,[ys]:i.LINEAR_MIPMAP_LINEAR},Jt={[Cg]:i.NEVER,[Cd]:i.ALWAYS,[Rg]:i.LESS,[Td]:i.LEQUAL,[Pg]:i.EQUAL,[Ad]:i.GEQUAL,[Ig]:i.GREATER,[Lg]:i.NOTEQUAL};function de(T,y){if(y.type===Ni&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Wn||y.magFilter===Cc||y.magFilter===Ca||y.magFilter===ys||y.minFilter===Wn||y.minFilter===Cc||y.minFilter===Ca||y.minFilter===ys)&&se("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(T,i.TEXTURE_WRAP_S,jt[y.wrapS]),i.texParameteri(T,i.TEXTURE_WRAP_T,jt[y.wrapT]),(T===i.TEXTURE_3D||T===i.TEXTURE_2D_ARRAY)&&i.texParameteri(T,i.TEXTURE_WRAP_R,jt[y.wrapR]),i.texParameteri(T,i.TEXTURE_MAG_FILTER,he[y.magFilter]),i.texParameteri(T,i.TEXTURE_MIN_FILTER,he[y.minFilter]),y.compareFunction&&(i.texParameteri(T,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(T,i.TEXTURE_COMPARE_FUNC,Jt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Cn||y.minFilter!==Ca&&y.minFilter!==ys||y.type===Ni&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let k=t.get("EXT_texture_filter_anisotropic");i.texParameterf(T,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function fe(T,y){let k=!1;T.__webglInit===void 0&&(T.__webglInit=!0,y.addEventListener("dispose",D),B(y));let st=y.source,Q=p.get(st);Q===void 0&&(Q={},p.set(st,Q));let mt=tt(y);if(mt!==T.__cacheKey){Q[mt]===void 0&&(Q[mt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,k=!0),Q[mt].usedTimes++;let vt=Q[T.__cacheKey];vt!==void 0&&(Q[T.__cacheKey].usedTimes--,vt.usedTimes===0&&H(y)),T.__cacheKey=mt,T.__webglTexture=Q[mt].texture}return k}function re(T,y,k){return Math.floor(Math.floor(T/k)/y)}function Ue(T,y,k,st){let mt=T.updateRanges;if(mt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,k,st,y.data);else{mt.sort((F,at)=>F.start-at.start);let vt=0;for(let F=1;F<mt.length;F++){let at=mt[vt],ot=mt[F],Pt=at.start+at.count,Tt=re(ot.start,y.width,4),Rt=re(at.start,y.width,4);ot.start<=Pt+1&&Tt===Rt&&re(ot.start+ot.count-1,y.width,4)===Tt?at.count=Math.max(at.count,ot.start+ot.count-at.start):(++vt,mt[vt]=ot)}mt.length=vt+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),rt=e.getParameter(i.UNPACK_SKIP_PIXELS),St=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let F=0,at=mt.length;F<at;F++){let ot=mt[F],Pt=Math.floor(ot.start/4),Tt=Math.ceil(ot.count/4),Rt=Pt%y.width,Qt=Math.floor(Pt/y.width),ie=Tt,lt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Qt),e.texSubImage2D(i.TEXTURE_2D,0,Rt,Qt,ie,lt,k,st,y.data)}T.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,St)}}function Le(T,y,k){let st=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(st=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(st=i.TEXTURE_3D);let Q=fe(T,y),mt=y.source;e.bindTexture(st,T.__webglTexture,i.TEXTURE0+k);let vt=n.get(mt);if(mt.version!==vt.__version||Q===!0){if(e.activeTexture(i.TEXTURE0+k),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let lt=we.getPrimaries(we.workingColorSpace),Ot=y.colorSpace===Ss?null:we.getPrimaries(y.colorSpace),te=y.colorSpace===Ss||lt===Ot?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment);let rt=M(y.image,!1,s.maxTextureSize);rt=Et(y,rt);let St=r.convert(y.format,y.colorSpace),F=r.convert(y.type),at=A(y.internalFormat,St,F,y.normalized,y.colorSpace,y.isVideoTexture);de(st,y);let ot,Pt=y.mipmaps,Tt=y.isVideoTexture!==!0,Rt=vt.__version===void 0||Q===!0,Qt=mt.dataReady,ie=E(y,rt);if(y.isDepthTexture)at=_(y.format===vs,y.type),Rt&&(Tt?e.texStorage2D(i.TEXTURE_2D,1,at,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,at,rt.width,rt.height,0,St,F,null));else if(y.isDataTexture)if(Pt.length>0){Tt&&Rt&&e.texStorage2D(i.TEXTURE_2D,ie,at,Pt[0].width,Pt[0].height);for(let lt=0,Ot=Pt.length;lt<Ot;lt++)ot=Pt[lt],Tt?Qt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,ot.width,ot.height,St,F,ot.data):e.texImage2D(i.TEXTURE_2D,lt,at,ot.width,ot.height,0,St,F,ot.data);y.generateMipmaps=!1}else Tt?(Rt&&e.texStorage2D(i.TEXTURE_2D,ie,at,rt.width,rt.height),Qt&&Ue(y,rt,St,F)):e.texImage2D(i.TEXTURE_2D,0,at,rt.width,rt.height,0,St,F,rt.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){Tt&&Rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ie,at,Pt[0].width,Pt[0].height,rt.depth);for(let lt=0,Ot=Pt.length;lt<Ot;lt++)if(ot=Pt[lt],y.format!==Fi)if(St!==null)if(Tt){if(Qt)if(y.layerUpdates.size>0){let te=Bd(ot.width,ot.height,y.format,y.type);for(let Ct of y.layerUpdates){let ae=ot.data.subarray(Ct*te/ot.data.BYTES_PER_ELEMENT,(Ct+1)*te/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,Ct,ot.width,ot.height,1,St,ae)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,ot.width,ot.height,rt.depth,St,ot.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,lt,at,ot.width,ot.height,rt.depth,0,ot.data,0,0);else se("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Tt?Qt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,ot.width,ot.height,rt.depth,St,F,ot.data):e.texImage3D(i.TEXTURE_2D_ARRAY,lt,at,ot.width,ot.height,rt.depth,0,St,F,ot.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{Tt&&Rt&&e.texStorage2D(i.TEXTURE_2D,ie,at,Pt[0].width,Pt[0].height);for(let lt=0,Ot=Pt.length;lt<Ot;lt++)ot=Pt[lt],y.format!==Fi?St!==null?Tt?Qt&&e.compressedTexSubImage2D(i.TEXTURE_2D,lt,0,0,ot.width,ot.height,St,ot.data):e.compressedTexImage2D(i.TEXTURE_2D,lt,at,ot.width,ot.height,0,ot.data):se("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Tt?Qt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,ot.width,ot.height,St,F,ot.data):e.texImage2D(i.TEXTURE_2D,lt,at,ot.width,ot.height,0,St,F,ot.data)}else if(y.isDataArrayTexture)if(Tt){if(Rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ie,at,rt.width,rt.height,rt.depth),Qt)if(y.layerUpdates.size>0){let lt=Bd(rt.width,rt.height,y.format,y.type);for(let Ot of y.layerUpdates){let te=rt.data.subarray(Ot*lt/rt.data.BYTES_PER_ELEMENT,(Ot+1)*lt/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ot,rt.width,rt.height,1,St,F,te)}y.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,St,F,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,at,rt.width,rt.height,rt.depth,0,St,F,rt.data);else if(y.isData3DTexture)Tt?(Rt&&e.texStorage3D(i.TEXTURE_3D,ie,at,rt.width,rt.height,rt.depth),Qt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,St,F,rt.data)):e.texImage3D(i.TEXTURE_3D,0,at,rt.width,rt.height,rt.depth,0,St,F,rt.data);else if(y.isFramebufferTexture){if(Rt)if(Tt)e.texStorage2D(i.TEXTURE_2D,ie,at,rt.width,rt.height);else{let lt=rt.width,Ot=rt.height;for(let te=0;te<ie;te++)e.texImage2D(i.TEXTURE_2D,te,at,lt,Ot,0,St,F,null),lt>>=1,Ot>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in i){let lt=i.canvas;if(lt.hasAttribute("layoutsubtree")||lt.setAttribute("layoutsubtree","true"),rt.parentNode!==lt){lt.appendChild(rt),d.add(y),lt.onpaint=Ot=>{let te=Ot.changedElements;for(let Ct of d)te.includes(Ct.image)&&(Ct.needsUpdate=!0)},lt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,rt);else{let te=i.RGBA,Ct=i.RGBA,ae=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,te,Ct,ae,rt)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Tt&&Rt){let lt=Gt(Pt[0]);e.texStorage2D(i.TEXTURE_2D,ie,at,lt.width,lt.height)}for(let lt=0,Ot=Pt.length;lt<Ot;lt++)ot=Pt[lt],Tt?Qt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,St,F,ot):e.texImage2D(i.TEXTURE_2D,lt,at,St,F,ot);y.generateMipmaps=!1}else if(Tt){if(Rt){let lt=Gt(rt);e.texStorage2D(i.TEXTURE_2D,ie,at,lt.width,lt.height)}Qt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,St,F,rt)}else e.texImage2D(i.TEXTURE_2D,0,at,St,F,rt);R(y)&&y.mipmapsAutoUpdate===!0&&v(st),vt.__version=mt.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function We(T,y,k){if(y.image.length!==6)return;let st=fe(T,y),Q=y.source;e.bindTexture(i.TEXTURE_CUBE_MAP,T.__webglTexture,i.TEXTURE0+k);let mt=n.get(Q);if(Q.version!==mt.__version||st===!0){e.activeTexture(i.TEXTURE0+k);let vt=we.getPrimaries(we.workingColorSpace),et=y.colorSpace===Ss?null:we.getPrimaries(y.colorSpace),rt=y.colorSpace===Ss||vt===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let St=y.isCompressedTexture||y.image[0].isCompressedTexture,F=y.image[0]&&y.image[0].isDataTexture,at=[];for(let Ct=0;Ct<6;Ct++)!St&&!F?at[Ct]=M(y.image[Ct],!0,s.maxCubemapSize):at[Ct]=F?y.image[Ct].image:y.image[Ct],at[Ct]=Et(y,at[Ct]);let ot=at[0],Pt=r.convert(y.format,y.colorSpace),Tt=r.convert(y.type),Rt=A(y.internalFormat,Pt,Tt,y.normalized,y.colorSpace),Qt=y.isVideoTexture!==!0,ie=mt.__version===void 0||st===!0,lt=Q.dataReady,Ot=E(y,ot);de(i.TEXTURE_CUBE_MAP,y);let te;if(y.isDepthTexture){if(Rt=_(y.format===vs,y.type),ie)if(Qt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Rt,ot.width,ot.height,0,Pt,Tt,null)}else if(St){Qt&&ie&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,Rt,ot.width,ot.height);for(let Ct=0;Ct<6;Ct++){te=at[Ct].mipmaps;for(let ae=0;ae<te.length;ae++){let ke=te[ae];y.format!==Fi?Pt!==null?Qt?lt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,ke.width,ke.height,Pt,ke.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,Rt,ke.width,ke.height,0,ke.data):se("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,ke.width,ke.height,Pt,Tt,ke.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,Rt,ke.width,ke.height,0,Pt,Tt,ke.data)}}}else{if(te=y.mipmaps,Qt&&ie){te.length>0&&Ot++;let Ct=Gt(at[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,Rt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(F){Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,at[Ct].width,at[Ct].height,Pt,Tt,at[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Rt,at[Ct].width,at[Ct].height,0,Pt,Tt,at[Ct].data);for(let ae=0;ae<te.length;ae++){let In=te[ae].image[Ct].image;Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,In.width,In.height,Pt,Tt,In.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,Rt,In.width,In.height,0,Pt,Tt,In.data)}}else{Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Pt,Tt,at[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Rt,Pt,Tt,at[Ct]);for(let ae=0;ae<te.length;ae++){let ke=te[ae];Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,Pt,Tt,ke.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,Rt,Pt,Tt,ke.image[Ct])}}}R(y)&&y.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),mt.__version=Q.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function K(T,y,k,st,Q,mt){let vt=r.convert(k.format,k.colorSpace),et=r.convert(k.type),rt=A(k.internalFormat,vt,et,k.normalized,k.colorSpace),St=n.get(y),F=n.get(k);if(F.__renderTarget=y,!St.__hasExternalTextures){let at=Math.max(1,y.width>>mt),ot=Math.max(1,y.height>>mt);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?e.texImage3D(Q,mt,rt,at,ot,y.depth,0,vt,et,null):e.texImage2D(Q,mt,rt,at,ot,0,vt,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,T),yt(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,st,Q,F.__webglTexture,0,Ut(y)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,st,Q,F.__webglTexture,mt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function dt(T,y,k){if(i.bindRenderbuffer(i.RENDERBUFFER,T),y.depthBuffer){let st=y.depthTexture,Q=st&&st.isDepthTexture?st.type:null,mt=_(y.stencilBuffer,Q),vt=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;yt(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(y),mt,y.width,y.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(y),mt,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,mt,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,vt,i.RENDERBUFFER,T)}else{let st=y.textures;for(let Q=0;Q<st.length;Q++){let mt=st[Q],vt=r.convert(mt.format,mt.colorSpace),et=r.convert(mt.type),rt=A(mt.internalFormat,vt,et,mt.normalized,mt.colorSpace);yt(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(y),rt,y.width,y.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(y),rt,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,rt,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(T,y,k){let st=y.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,T),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(y.depthTexture);Q.__renderTarget=y;let mt=st?y.depthTexture.image[0]:y.depthTexture.image;(!Q.__webglTexture||mt.width!==y.width||mt.height!==y.height)&&(mt.width=y.width,mt.height=y.height,y.depthTexture.needsUpdate=!0),st?At(y.depthTexture,0):gt(y.depthTexture,0);let vt=Q.__webglTexture,et=Ut(y),rt=st?i.TEXTURE_CUBE_MAP_POSITIVE_X+k:i.TEXTURE_2D,St=y.depthTexture.format===vs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(y.depthTexture.format===ps)yt(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,St,rt,vt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,St,rt,vt,0);else if(y.depthTexture.format===vs)yt(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,St,rt,vt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,St,rt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function bt(T){let y=n.get(T),k=T.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==T.depthTexture){let st=T.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),st){let Q=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,st.removeEventListener("dispose",Q)};st.addEventListener("dispose",Q),y.__depthDisposeCallback=Q}y.__boundDepthTexture=st}if(T.depthTexture&&!y.__autoAllocateDepthBuffer)if(k)for(let st=0;st<6;st++)xt(y.__webglFramebuffer[st],T,st);else T.texture.mipmaps.length>0?xt(y.__webglFramebuffer[0],T,0):xt(y.__webglFramebuffer,T,0);else if(k){y.__webglDepthbuffer=[];for(let st=0;st<6;st++)if(e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[st]),y.__webglDepthbuffer[st]===void 0)y.__webglDepthbuffer[st]=i.createRenderbuffer(),dt(y.__webglDepthbuffer[st],T,!1);else{let Q=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,mt=y.__webglDepthbuffer[st];i.bindRenderbuffer(i.RENDERBUFFER,mt),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,mt)}}else if(T.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),dt(y.__webglDepthbuffer,T,!1);else{let Q=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,mt=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,mt),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,mt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function _t(T,y,k){let st=n.get(T);y!==void 0&&K(st.__webglFramebuffer,T,T.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),k!==void 0&&bt(T)}function Yt(T){let y=T.texture,k=n.get(T),st=n.get(y);T.addEventListener("dispose",z),B(T);let Q=T.textures,mt=T.isWebGLCubeRenderTarget===!0,vt=Q.length>1;if(vt||(st.__webglTexture===void 0&&(st.__webglTexture=i.createTexture()),st.__version=y.version,o.memory.textures++),mt){k.__webglFramebuffer=[];for(let et=0;et<6;et++)if(y.mipmaps.length>0){k.__webglFramebuffer[et]=[];for(let rt=0;rt<y.mipmaps.length;rt++)k.__webglFramebuffer[et][rt]=i.createFramebuffer()}else k.__webglFramebuffer[et]=i.createFramebuffer()}else{if(y.mipmaps.length>0){k.__webglFramebuffer=[];for(let et=0;et<y.mipmaps.length;et++)k.__webglFramebuffer[et]=i.createFramebuffer()}else k.__webglFramebuffer=i.createFramebuffer();if(vt)for(let et=0,rt=Q.length;et<rt;et++){let St=n.get(Q[et]);St.__webglTexture===void 0&&(St.__webglTexture=i.createTexture(),o.memory.textures++)}if(T.samples>0&&yt(T)===!1){k.__webglMultisampledFramebuffer=i.createFramebuffer(),k.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let et=0;et<Q.length;et++){let rt=Q[et];k.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,k.__webglColorRenderbuffer[et]);let St=r.convert(rt.format,rt.colorSpace),F=r.convert(rt.type),at=A(rt.internalFormat,St,F,rt.normalized,rt.colorSpace,T.isXRRenderTarget===!0),ot=Ut(T);i.renderbufferStorageMultisample(i.RENDERBUFFER,ot,at,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,k.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),T.depthBuffer&&(k.__webglDepthRenderbuffer=i.createRenderbuffer(),dt(k.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(mt){e.bindTexture(i.TEXTURE_CUBE_MAP,st.__webglTexture),de(i.TEXTURE_CUBE_MAP,y);for(let et=0;et<6;et++)if(y.mipmaps.length>0)for(let rt=0;rt<y.mipmaps.length;rt++)K(k.__webglFramebuffer[et][rt],T,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,rt);else K(k.__webglFramebuffer[et],T,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);R(y)?v(i.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let et=0,rt=Q.length;et<rt;et++){let St=Q[et],F=n.get(St),at=i.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(at=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(at,F.__webglTexture),de(at,St),K(k.__webglFramebuffer,T,St,i.COLOR_ATTACHMENT0+et,at,0),R(St)&&v(at)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(et=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,st.__webglTexture),de(et,y),y.mipmaps.length>0)for(let rt=0;rt<y.mipmaps.length;rt++)K(k.__webglFramebuffer[rt],T,y,i.COLOR_ATTACHMENT0,et,rt);else K(k.__webglFramebuffer,T,y,i.COLOR_ATTACHMENT0,et,0);R(y)?v(et):y.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),e.unbindTexture()}T.depthBuffer&&bt(T)}function P(T){let y=T.textures;for(let k=0,st=y.length;k<st;k++){let Q=y[k];if(R(Q)&&Q.mipmapsAutoUpdate===!0){let mt=C(T),vt=n.get(Q).__webglTexture;e.bindTexture(mt,vt),v(mt),e.unbindTexture()}}}let ut=[];function kt(T){if(T.samples>0){if(yt(T)===!1){let y=T.textures,k=T.width,st=T.height,Q=i.COLOR_BUFFER_BIT,mt=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=n.get(T),et=y.length>1;if(et)for(let St=0;St<y.length;St++)e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let St=0;St<y.length;St++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,vt.__webglColorRenderbuffer[St]);let F=n.get(y[St]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,k,st,0,0,k,st,Q,i.NEAREST),l===!0&&(ut.length=0,ut.push(i.COLOR_ATTACHMENT0+St),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&ut.push(mt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ut))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let St=0;St<y.length;St++){e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.RENDERBUFFER,vt.__webglColorRenderbuffer[St]);let F=n.get(y[St]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.TEXTURE_2D,F,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&l){let y=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function Ut(T){return Math.min(s.maxSamples,T.samples)}function yt(T){let y=n.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Xt(T){let y=o.render.frame;h.get(T)!==y&&(h.set(T,y),T.update())}function Et(T,y){let k=T.colorSpace,st=T.format,Q=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||k!==sa&&k!==Ss&&(we.getTransfer(k)===Ne?(st!==Fi||Q!==Zn)&&se("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ce("WebGLTextures: Unsupported texture color space:",k)),y}function Gt(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(c.width=T.naturalWidth||T.width,c.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(c.width=T.displayWidth,c.height=T.displayHeight):(c.width=T.width,c.height=T.height),c}this.allocateTextureUnit=ht,this.resetTextureUnits=j,this.getTextureUnits=it,this.setTextureUnits=pt,this.setTexture2D=gt,this.setTexture2DArray=Mt,this.setTexture3D=Lt,this.setTextureCube=At,this.rebindTextures=_t,this.setupRenderTarget=Yt,this.updateRenderTargetMipmap=P,this.updateMultisampleRenderTarget=kt,this.setupDepthRenderbuffer=bt,this.setupFrameBufferTexture=K,this.useMultisampledRTT=yt,this.dispose=V}function Zw(i,t){function e(n,s=Ss){let r,o=we.getTransfer(s);if(n===Zn)return i.UNSIGNED_BYTE;if(n===Pc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ic)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Sd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Md)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yd)return i.BYTE;if(n===vd)return i.SHORT;if(n===Eo)return i.UNSIGNED_SHORT;if(n===Rc)return i.INT;if(n===Di)return i.UNSIGNED_INT;if(n===Ni)return i.FLOAT;if(n===Ui)return i.HALF_FLOAT;if(n===bd)return i.ALPHA;if(n===wd)return i.RGB;if(n===Fi)return i.RGBA;if(n===ps)return i.DEPTH_COMPONENT;if(n===vs)return i.DEPTH_STENCIL;if(n===Ed)return i.RED;if(n===Lc)return i.RED_INTEGER;if(n===Ys)return i.RG;if(n===Dc)return i.RG_INTEGER;if(n===Nc)return i.RGBA_INTEGER;if(n===Ra||n===Pa||n===Ia||n===La)if(o===Ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ra)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ra)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Pa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ia)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===La)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Uc||n===Fc||n===Oc||n===Bc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Uc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Fc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Oc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Bc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===zc||n===kc||n===Gc||n===Vc||n===Hc||n===Da||n===Wc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===zc||n===kc)return o===Ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Gc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Vc)return r.COMPRESSED_R11_EAC;if(n===Hc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Da)return r.COMPRESSED_RG11_EAC;if(n===Wc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Xc||n===qc||n===Yc||n===$c||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===th||n===eh||n===nh||n===ih||n===sh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Xc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===qc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Yc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===$c)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Zc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Jc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Kc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===jc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Qc)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===th)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===eh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===nh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ih)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===sh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===rh||n===oh||n===ah)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===rh)return o===Ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===oh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ah)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===lh||n===ch||n===Na||n===hh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===lh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Na)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===hh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===mr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Jw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Kw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Yd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ga(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Ji({vertexShader:Jw,fragmentShader:Kw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new an(new xa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},$d=class extends Ii{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,p=null,g=null,S=typeof XRWebGLBinding<"u",m=new Yd,f={},M=e.getContextAttributes(),R=null,v=null,C=[],A=[],_=new Zt,E=null,B=null,N=new Hn;N.viewport=new Ce;let D=new Hn;D.viewport=new Ce;let z=[N,D],W=new wc,L=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=C[tt];return gt===void 0&&(gt=new po,C[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=C[tt];return gt===void 0&&(gt=new po,C[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=C[tt];return gt===void 0&&(gt=new po,C[tt]=gt),gt.getHandSpace()};function q(tt){let gt=A.indexOf(tt.inputSource);if(gt===-1)return;let Mt=C[gt];Mt!==void 0&&(Mt.update(tt.inputSource,tt.frame,c||o),Mt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<C.length;tt++){let gt=A[tt];gt!==null&&(A[tt]=null,C[tt].disconnect(gt))}L=null,V=null,m.reset();for(let tt in f)delete f[tt];if(t.setRenderTarget(R),p=null,u=null,d=null,s=null,v=null,ht.stop(),n.isPresenting=!1,t.setPixelRatio(E),t.setSize(_.width,_.height,!1),B!==null){let tt=B.camera;tt.fov=B.fov,tt.zoom=B.zoom,tt.updateProjectionMatrix(),B=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&se("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&se("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return d===null&&S&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(R=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ct),M.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(_),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let Mt=null,Lt=null,At=null;M.depth&&(At=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Mt=M.stencil?vs:ps,Lt=M.stencil?mr:Di);let jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(jt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),v=new li(u.textureWidth,u.textureHeight,{format:Fi,type:Zn,depthTexture:new xs(u.textureWidth,u.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,Mt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let Mt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,Mt),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),v=new li(p.framebufferWidth,p.framebufferHeight,{format:Fi,type:Zn,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ht.setContext(s),ht.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(tt){for(let gt=0;gt<tt.removed.length;gt++){let Mt=tt.removed[gt],Lt=A.indexOf(Mt);Lt>=0&&(A[Lt]=null,C[Lt].disconnect(Mt))}for(let gt=0;gt<tt.added.length;gt++){let Mt=tt.added[gt],Lt=A.indexOf(Mt);if(Lt===-1){for(let jt=0;jt<C.length;jt++)if(jt>=A.length){A.push(Mt),Lt=jt;break}else if(A[jt]===null){A[jt]=Mt,Lt=jt;break}if(Lt===-1)break}let At=C[Lt];At&&At.connect(Mt)}}function Y(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,Mt=tt.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(Mt=m.depthFar)),W.near=D.near=N.near=gt,W.far=D.far=N.far=Mt,(L!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),L=W.near,V=W.far),W.layers.mask=tt.layers.mask|6,N.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Lt=tt.parent,At=W.cameras;Y(W,Lt);for(let jt=0;jt<At.length;jt++)Y(At[jt],Lt);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),B===null&&tt.isPerspectiveCamera&&(B={camera:tt,fov:tt.fov,zoom:tt.zoom}),j(tt,W,Lt)};function j(tt,gt,Mt){Mt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(Mt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=ho*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function(tt){l=tt,u!==null&&(u.fixedFoveation=tt),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(tt){return f[tt]};let it=null;function pt(tt,gt){if(h=gt.getViewerPose(c||o),g=gt,h!==null){let Mt=h.views;p!==null&&(t.setRenderTargetFramebuffer(v,p.framebuffer),t.setRenderTarget(v));let Lt=!1;Mt.length!==W.cameras.length&&(W.cameras.length=0,Lt=!0);for(let Jt=0;Jt<Mt.length;Jt++){let de=Mt[Jt],fe=null;if(p!==null)fe=p.getViewport(de);else{let Ue=d.getViewSubImage(u,de);fe=Ue.viewport,Jt===0&&(t.setRenderTargetTextures(v,Ue.colorTexture,Ue.depthStencilTexture),t.setRenderTarget(v))}let re=z[Jt];re===void 0&&(re=new Hn,re.layers.enable(Jt),re.viewport=new Ce,z[Jt]=re),re.matrix.fromArray(de.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(de.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(fe.x,fe.y,fe.width,fe.height),Jt===0&&(W.matrix.copy(re.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Lt===!0&&W.cameras.push(re)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){d=n.getBinding();let Jt=d.getDepthInformation(Mt[0]);Jt&&Jt.isValid&&Jt.texture&&m.init(Jt,s.renderState)}if(At&&At.includes("camera-access")&&S){t.state.unbindTexture(),d=n.getBinding();for(let Jt=0;Jt<Mt.length;Jt++){let de=Mt[Jt].camera;if(de){let fe=f[de];fe||(fe=new ga,f[de]=fe);let re=d.getCameraImage(de);fe.sourceTexture=re}}}}for(let Mt=0;Mt<C.length;Mt++){let Lt=A[Mt],At=C[Mt];Lt!==null&&At!==void 0&&At.update(Lt,gt,c||o)}it&&it(tt,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),g=null}let ht=new c0;ht.setAnimationLoop(pt),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},jw=new me,y0=new oe;y0.set(-1,0,0,0,1,0,0,0,1);function Qw(i,t){function e(m,f){m.matrixAutoUpdate===!0&&m.updateMatrix(),f.value.copy(m.matrix)}function n(m,f){f.color.getRGB(m.fogColor.value,Ud(i)),f.isFog?(m.fogNear.value=f.near,m.fogFar.value=f.far):f.isFogExp2&&(m.fogDensity.value=f.density)}function s(m,f,M,R,v){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(m,f):f.isMeshLambertMaterial?(r(m,f),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(m,f),d(m,f)):f.isMeshPhongMaterial?(r(m,f),h(m,f),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(m,f),u(m,f),f.isMeshPhysicalMaterial&&p(m,f,v)):f.isMeshMatcapMaterial?(r(m,f),g(m,f)):f.isMeshDepthMaterial?r(m,f):f.isMeshDistanceMaterial?(r(m,f),S(m,f)):f.isMeshNormalMaterial?r(m,f):f.isLineBasicMaterial?(o(m,f),f.isLineDashedMaterial&&a(m,f)):f.isPointsMaterial?l(m,f,M,R):f.isSpriteMaterial?c(m,f):f.isShadowMaterial?(m.color.value.copy(f.color),m.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(m,f){m.opacity.value=f.opacity,f.color&&m.diffuse.value.copy(f.color),f.emissive&&m.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.bumpMap&&(m.bumpMap.value=f.bumpMap,e(f.bumpMap,m.bumpMapTransform),m.bumpScale.value=f.bumpScale,f.side===qn&&(m.bumpScale.value*=-1)),f.normalMap&&(m.normalMap.value=f.normalMap,e(f.normalMap,m.normalMapTransform),m.normalScale.value.copy(f.normalScale),f.side===qn&&m.normalScale.value.negate()),f.displacementMap&&(m.displacementMap.value=f.displacementMap,e(f.displacementMap,m.displacementMapTransform),m.displacementScale.value=f.displacementScale,m.displacementBias.value=f.displacementBias),f.emissiveMap&&(m.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,m.emissiveMapTransform)),f.specularMap&&(m.specularMap.value=f.specularMap,e(f.specularMap,m.specularMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest);let M=t.get(f),R=M.envMap,v=M.envMapRotation;R&&(m.envMap.value=R,m.envMapRotation.value.setFromMatrix4(jw.makeRotationFromEuler(v)).transpose(),R.isCubeTexture&&R.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(y0),m.reflectivity.value=f.reflectivity,m.ior.value=f.ior,m.refractionRatio.value=f.refractionRatio),f.lightMap&&(m.lightMap.value=f.lightMap,m.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,m.lightMapTransform)),f.aoMap&&(m.aoMap.value=f.aoMap,m.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,m.aoMapTransform))}function o(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform))}function a(m,f){m.dashSize.value=f.dashSize,m.totalSize.value=f.dashSize+f.gapSize,m.scale.value=f.scale}function l(m,f,M,R){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.size.value=f.size*M,m.scale.value=R*.5,f.map&&(m.map.value=f.map,e(f.map,m.uvTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function c(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.rotation.value=f.rotation,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function h(m,f){m.specular.value.copy(f.specular),m.shininess.value=Math.max(f.shininess,1e-4)}function d(m,f){f.gradientMap&&(m.gradientMap.value=f.gradientMap)}function u(m,f){m.metalness.value=f.metalness,f.metalnessMap&&(m.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,m.metalnessMapTransform)),m.roughness.value=f.roughness,f.roughnessMap&&(m.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,m.roughnessMapTransform)),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)}function p(m,f,M){m.ior.value=f.ior,f.diffuseRoughness>0&&(m.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=f.diffuseRoughnessMap,e(f.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),f.sheen>0&&(m.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),m.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(m.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,m.sheenColorMapTransform)),f.sheenRoughnessMap&&(m.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,m.sheenRoughnessMapTransform))),f.clearcoat>0&&(m.clearcoat.value=f.clearcoat,m.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(m.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,m.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(m.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===qn&&m.clearcoatNormalScale.value.negate())),f.dispersion>0&&(m.dispersion.value=f.dispersion),f.retroreflectivity>0&&(m.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(m.iridescence.value=f.iridescence,m.iridescenceIOR.value=f.iridescenceIOR,m.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(m.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,m.iridescenceMapTransform)),f.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),f.transmission>0&&(m.transmission.value=f.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(m.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,m.transmissionMapTransform)),m.thickness.value=f.thickness,f.thicknessMap&&(m.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=f.attenuationDistance,m.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(m.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(m.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=f.specularIntensity,m.specularColor.value.copy(f.specularColor),f.specularColorMap&&(m.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,m.specularColorMapTransform)),f.specularIntensityMap&&(m.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,f){f.matcap&&(m.matcap.value=f.matcap)}function S(m,f){let M=t.get(f).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function tE(i,t,e,n){let s={},r={};function o(M,R){let v=R.program;n.uniformBlockBinding(M,v,s[M.id])}function a(M,R){let v=s[M.id];v===void 0&&(g(M),v=l(M),s[M.id]=v,M.addEventListener("dispose",m));let C=R.program;n.updateUBOMapping(M,C);let A=t.render.frame;r[M.id]!==A&&(c(M),r[M.id]=A)}function l(M){let R=i.createBuffer(),v=M.__size,C=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,R),i.bufferData(i.UNIFORM_BUFFER,v,C),i.bindBuffer(i.UNIFORM_BUFFER,null),R}function c(M){let R=s[M.id],v=M.uniforms,C=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,R);for(let A=0,_=v.length;A<_;A++){let E=v[A];if(Array.isArray(E))for(let B=0,N=E.length;B<N;B++)h(E[B],A,B,C);else h(E,A,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(M,R,v,C){if(u(M,R,v,C)===!0){let A=M.__offset,_=M.value;if(Array.isArray(_)){let E=0;for(let B=0;B<_.length;B++){let N=_[B],D=S(N,!0);d(N,M.__data,E),E+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,M.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,M.__data)}}function d(M,R,v){typeof M=="number"||typeof M=="boolean"?R[v]=M:M.isMatrix3?(R[v]=M.elements[0],R[v+1]=M.elements[1],R[v+2]=M.elements[2],R[v+3]=0,R[v+4]=M.elements[3],R[v+5]=M.elements[4],R[v+6]=M.elements[5],R[v+7]=0,R[v+8]=M.elements[6],R[v+9]=M.elements[7],R[v+10]=M.elements[8],R[v+11]=0):ArrayBuffer.isView(M)?R.set(M.subarray(0,R.length-v),v):M.toArray(R,v)}function u(M,R,v,C){let A=M.value,_=R+"_"+v;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);let E=C[_],B=!1;for(let N=0;N<A.length;N++)p(A[N],E,N)===!0&&(B=!0);return B}return p(A,C,_)}function p(M,R,v){if(R[v]===void 0)return typeof M=="number"||typeof M=="boolean"?R[v]=M:ArrayBuffer.isView(M)?R[v]=M.slice():R[v]=M.clone(),!0;{let C=R[v];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return R[v]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function g(M){let R=M.uniforms,v=0,C=16;for(let _=0,E=R.length;_<E;_++){let B=Array.isArray(R[_])?R[_]:[R[_]];for(let N=0,D=B.length;N<D;N++){let z=B[N],W=Array.isArray(z.value)?z.value:[z.value],L=Array.isArray(R[_])||Array.isArray(z.value),V=v;for(let H=0,ct=W.length;H<ct;H++){let Y=W[H],j=S(Y,L),it=v%C,pt=it%j.boundary,ht=it+pt;v+=pt,ht!==0&&C-ht<j.storage&&(v+=C-ht),H===0&&(V=v),v+=j.storage}let q=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new q((v-V)/Float32Array.BYTES_PER_ELEMENT),z.__offset=V}}let A=v%C;return A>0&&(v+=C-A),M.__size=v,M.__cache={},this}function S(M,R){let v={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(v.boundary=4,v.storage=4):M.isVector2?(v.boundary=8,v.storage=8):M.isVector3||M.isColor?(v.boundary=16,v.storage=12):M.isVector4?(v.boundary=16,v.storage=16):M.isMatrix3?(v.boundary=16,v.storage=48):M.isMatrix4?(v.boundary=16,v.storage=64):M.isTexture?se("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(v.boundary=16,v.storage=M.byteLength):se("WebGLRenderer: Unsupported uniform value type.",M),R===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(M){let R=M.target;R.removeEventListener("dispose",m),i.deleteBuffer(s[R.id]),delete s[R.id],delete r[R.id]}function f(){for(let M in s)i.deleteBuffer(s[M]);s={},r={}}return{bind:o,update:a,dispose:f}}var eE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ji=null;function nE(){return ji===null&&(ji=new oc(eE,16,16,Ys,Ui),ji.name="DFG_LUT",ji.minFilter=Wn,ji.magFilter=Wn,ji.wrapS=Yi,ji.wrapT=Yi,ji.generateMipmaps=!1,ji.needsUpdate=!0),ji}var Ba=class{constructor(t={}){let{canvas:e=Dg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:p=Zn}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let S=p,m=new Set([Nc,Dc,Lc]),f=new Set([Zn,Di,Eo,mr,Pc,Ic]),M=new Uint32Array(4),R=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},C=null,A=null,_=[],E=[],B=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ki,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,D=!1,z=null,W=null,L=null,V=null;this._outputColorSpace=Vn;let q=0,H=0,ct=null,Y=-1,j=null,it=new Ce,pt=new Ce,ht=null,tt=new ee(0),gt=0,Mt=e.width,Lt=e.height,At=1,jt=null,he=null,Jt=new Ce(0,0,Mt,Lt),de=new Ce(0,0,Mt,Lt),fe=!1,re=new Zi,Ue=new ac,Le=!1,We=!1,K=new me,dt=new O,xt=new Ce,bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_t=!1;function Yt(){return ct===null?At:1}let P=n;function ut(w,G){return e.getContext(w,G)}let kt,Ut,yt,Xt,Et,Gt,T,y,k,st,Q,mt,vt,et,rt,St,F,at,ot,Pt,Tt,Rt,Qt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),P===null){let G="webgl2";if(P=ut(G,w),P===null)throw ut(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ie()}catch(w){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ce("WebGLRenderer: "+w.message),w}function ie(){kt=new fb(P),kt.init(),Tt=new Zw(P,kt),Ut=new nb(P,kt,t,Tt),yt=new Yw(P,kt),Ut.reversedDepthBuffer&&u&&yt.buffers.depth.setReversed(!0),W=P.createFramebuffer(),L=P.createFramebuffer(),V=P.createFramebuffer(),Xt=new gb(P),Et=new Dw,Gt=new $w(P,kt,yt,Et,Ut,Tt,Xt),T=new db(N),y=new xv(P),Rt=new tb(P,y),k=new pb(P,y,Xt,Rt),st=new xb(P,k,y,Rt,Xt),at=new _b(P,Ut,Gt),rt=new ib(Et),Q=new Lw(N,T,kt,Ut,Rt,rt),mt=new Qw(N,Et),vt=new Uw,et=new Gw(kt),F=new QM(N,T,yt,st,g,l),St=new qw(N,st,Ut),Qt=new tE(P,Xt,Ut,yt),ot=new eb(P,kt,Xt),Pt=new mb(P,kt,Xt),Xt.programs=Q.programs,N.capabilities=Ut,N.extensions=kt,N.properties=Et,N.renderLists=vt,N.shadowMap=St,N.state=yt,N.info=Xt}S!==Zn&&(B=new vb(S,e.width,e.height,a,s,r));let lt=new $d(N,P);this.xr=lt,this.getContext=function(){return P},this.getContextAttributes=function(){return P.getContextAttributes()},this.forceContextLoss=function(){let w=kt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=kt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(w){w!==void 0&&(At=w,this.setSize(Mt,Lt,!1))},this.getSize=function(w){return w.set(Mt,Lt)},this.setSize=function(w,G,nt=!0){if(lt.isPresenting){se("WebGLRenderer: Can't change size while VR device is presenting.");return}Mt=w,Lt=G,e.width=Math.floor(w*At),e.height=Math.floor(G*At),nt===!0&&(e.style.width=w+"px",e.style.height=G+"px"),B!==null&&B.setSize(e.width,e.height),this.setViewport(0,0,w,G)},this.getDrawingBufferSize=function(w){return w.set(Mt*At,Lt*At).floor()},this.setDrawingBufferSize=function(w,G,nt){Mt=w,Lt=G,At=nt,e.width=Math.floor(w*nt),e.height=Math.floor(G*nt),this.setViewport(0,0,w,G)},this.setEffects=function(w){if(S===Zn){ce("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let G=0;G<w.length;G++)if(w[G].isOutputPass===!0){se("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(it)},this.getViewport=function(w){return w.copy(Jt)},this.setViewport=function(w,G,nt,$){w.isVector4?Jt.set(w.x,w.y,w.z,w.w):Jt.set(w,G,nt,$),yt.viewport(it.copy(Jt).multiplyScalar(Yt()).round())},this.getScissor=function(w){return w.copy(de)},this.setScissor=function(w,G,nt,$){w.isVector4?de.set(w.x,w.y,w.z,w.w):de.set(w,G,nt,$),yt.scissor(pt.copy(de).multiplyScalar(Yt()).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(w){yt.setScissorTest(fe=w)},this.setOpaqueSort=function(w){jt=w},this.setTransparentSort=function(w){he=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,G=!0,nt=!0){let $=0;if(w){let Z=!1;if(ct!==null){let Dt=ct.texture.format;Z=m.has(Dt)}if(Z){let Dt=ct.texture.type,Ft=f.has(Dt),Nt=F.getClearColor(),Bt=F.getClearAlpha(),Kt=Nt.r,ue=Nt.g,xe=Nt.b;Ft?(M[0]=Kt,M[1]=ue,M[2]=xe,M[3]=Bt,P.clearBufferuiv(P.COLOR,0,M)):(R[0]=Kt,R[1]=ue,R[2]=xe,R[3]=Bt,P.clearBufferiv(P.COLOR,0,R))}else $|=P.COLOR_BUFFER_BIT}G&&($|=P.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&($|=P.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&P.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),z=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),F.dispose(),vt.dispose(),et.dispose(),Gt.dispose(),Et.dispose(),T.dispose(),st.dispose(),k.dispose(),Rt.dispose(),Qt.dispose(),Q.dispose(),lt.dispose(),lt.removeEventListener("sessionstart",$a),lt.removeEventListener("sessionend",Oi),ts.stop()};function Ot(w){w.preventDefault(),aa("WebGLRenderer: Context Lost."),D=!0}function te(){aa("WebGLRenderer: Context Restored."),D=!1;let w=Xt.autoReset,G=St.enabled,nt=St.autoUpdate,$=St.needsUpdate,Z=St.type;ie(),Xt.autoReset=w,St.enabled=G,St.autoUpdate=nt,St.needsUpdate=$,St.type=Z}function Ct(w){ce("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function ae(w){let G=w.target;G.removeEventListener("dispose",ae),ke(G)}function ke(w){In(w),Et.remove(w)}function In(w){let G=Et.get(w).programs;G!==void 0&&(G.forEach(function(nt){Q.releaseProgram(nt)}),w.isShaderMaterial&&Q.releaseShaderCache(w))}this.renderBufferDirect=function(w,G,nt,$,Z,Dt){G===null&&(G=bt);let Ft=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Nt=Lo(w,G,nt,$,Z);yt.setMaterial($,Ft);let Bt=nt.index,Kt=1;if($.wireframe===!0){if(Bt=k.getWireframeAttribute(nt),Bt===void 0)return;Kt=2}let ue=nt.drawRange,xe=nt.attributes.position,$t=ue.start*Kt,ye=(ue.start+ue.count)*Kt;Dt!==null&&($t=Math.max($t,Dt.start*Kt),ye=Math.min(ye,(Dt.start+Dt.count)*Kt)),Bt!==null?($t=Math.max($t,0),ye=Math.min(ye,Bt.count)):xe!=null&&($t=Math.max($t,0),ye=Math.min(ye,xe.count));let je=ye-$t;if(je<0||je===1/0)return;Rt.setup(Z,$,Nt,nt,Bt);let Fe,Oe=ot;if(Bt!==null&&(Fe=y.get(Bt),Oe=Pt,Oe.setIndex(Fe)),Z.isMesh)$.wireframe===!0?(yt.setLineWidth($.wireframeLinewidth*Yt()),Oe.setMode(P.LINES)):Oe.setMode(P.TRIANGLES);else if(Z.isLine){let pn=$.linewidth;pn===void 0&&(pn=1),yt.setLineWidth(pn*Yt()),Z.isLineSegments?Oe.setMode(P.LINES):Z.isLineLoop?Oe.setMode(P.LINE_LOOP):Oe.setMode(P.LINE_STRIP)}else Z.isPoints?Oe.setMode(P.POINTS):Z.isSprite&&Oe.setMode(P.TRIANGLES);if(Z.isBatchedMesh)if(kt.get("WEBGL_multi_draw"))Oe.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let pn=Z._multiDrawStarts,Wt=Z._multiDrawCounts,ln=Z._multiDrawCount,Me=Bt?y.get(Bt).bytesPerElement:1,ns=Et.get($).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)ns.setValue(P,"_gl_DrawID",cn),Oe.render(pn[cn]/Me,Wt[cn])}else if(Z.isInstancedMesh)Oe.renderInstances($t,je,Z.count);else if(nt.isInstancedBufferGeometry){let pn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Wt=Math.min(nt.instanceCount,pn);Oe.renderInstances($t,je,Wt)}else Oe.render($t,je)};function Ro(w,G,nt,$){z!==null&&w.isNodeMaterial&&z.setObject($,w),Le===!0&&rt.setState(w,nt,!1),w.transparent===!0&&w.side===Yn&&w.forceSinglePass===!1?(w.side=qn,w.needsUpdate=!0,Bi(w,G,$),w.side=qs,w.needsUpdate=!0,Bi(w,G,$),w.side=Yn):Bi(w,G,$)}this.compile=function(w,G,nt=null){nt===null&&(nt=w),z!==null&&z.renderStart(w,G,nt),A=et.get(nt),A.init(G),E.push(A),nt.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),w!==nt&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),z!==null&&z.updateLights(A.state.lightsArray),We=this.localClippingEnabled,Le=rt.init(this.clippingPlanes,We),Le===!0&&rt.setGlobalState(this.clippingPlanes,G),z!==null&&St.render(A.state.shadowsArray,nt,G);let $=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Dt=Z.material;if(Dt)if(Array.isArray(Dt))for(let Ft=0;Ft<Dt.length;Ft++){let Nt=Dt[Ft];Ro(Nt,nt,G,Z),$.add(Nt)}else Ro(Dt,nt,G,Z),$.add(Dt)}),A=E.pop(),z!==null&&z.renderEnd(),$},this.compileAsync=function(w,G,nt=null){let $=this.compile(w,G,nt);return new Promise(Z=>{function Dt(){if($.forEach(function(Ft){let Bt=Et.get(Ft).currentProgram;(Bt===void 0||Bt.isReady())&&$.delete(Ft)}),$.size===0){Z(w);return}setTimeout(Dt,10)}kt.get("KHR_parallel_shader_compile")!==null?Dt():setTimeout(Dt,10)})};let xr=null;function Bh(w){xr&&xr(w)}function $a(){ts.stop()}function Oi(){ts.start()}let ts=new c0;ts.setAnimationLoop(Bh),typeof self<"u"&&ts.setContext(self),this.setAnimationLoop=function(w){xr=w,lt.setAnimationLoop(w),w===null?ts.stop():ts.start()},lt.addEventListener("sessionstart",$a),lt.addEventListener("sessionend",Oi),this.render=function(w,G){if(G!==void 0&&G.isCamera!==!0){ce("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(w,G);let nt=lt.enabled===!0&&lt.isPresenting===!0,$=B!==null&&(ct===null||nt)&&B.begin(N,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),lt.enabled===!0&&lt.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(lt.cameraAutoUpdate===!0&&lt.updateCamera(G),G=lt.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,G,ct),A=et.get(w,E.length),A.init(G),A.state.textureUnits=Gt.getTextureUnits(),E.push(A),K.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Ue.setFromArrayCamera(G):re.setFromProjectionMatrix(K,yi,G.reversedDepth),We=this.localClippingEnabled,Le=rt.init(this.clippingPlanes,We),C=vt.get(w,_.length),C.init(),_.push(C),this.info.render.frame++,lt.enabled===!0&&lt.isPresenting===!0){let Ft=N.xr.getDepthSensingMesh();Ft!==null&&es(Ft,G,-1/0,N.sortObjects)}es(w,G,0,N.sortObjects),C.finish(),z!==null&&z.updateLights(A.state.lightsArray),N.sortObjects===!0&&C.sort(jt,he),_t=lt.enabled===!1||lt.isPresenting===!1||lt.hasDepthSensing()===!1,_t&&F.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),Le===!0&&rt.beginShadows();let Z=A.state.shadowsArray;if(St.render(Z,w,G),Le===!0&&rt.endShadows(),($&&B.hasRenderPass())===!1){let Ft=C.opaque,Nt=C.transmissive;if(A.setupLights(),G.isArrayCamera){let Bt=G.cameras;if(Nt.length>0)for(let Kt=0,ue=Bt.length;Kt<ue;Kt++){let xe=Bt[Kt];Mi(Ft,Nt,w,xe)}_t&&F.render(w);for(let Kt=0,ue=Bt.length;Kt<ue;Kt++){let xe=Bt[Kt];Po(C,w,xe,xe.viewport)}}else Nt.length>0&&Mi(Ft,Nt,w,G),_t&&F.render(w),Po(C,w,G)}ct!==null&&H===0&&(Gt.updateMultisampleRenderTarget(ct),Gt.updateRenderTargetMipmap(ct)),$&&B.end(N),w.isScene===!0&&w.onAfterRender(N,w,G),Rt.resetDefaultState(),Y=-1,j=null,E.pop(),E.length>0?(A=E[E.length-1],Gt.setTextureUnits(A.state.textureUnits),Le===!0&&rt.setGlobalState(N.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,z!==null&&z.renderEnd()};function es(w,G,nt,$){if(w.visible===!1)return;if(w.layers.test(G.layers)){if(w.isGroup)nt=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(G);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Ft=G.isArrayCamera?Ue:re;if(!w.frustumCulled||w.intersectsFrustum(Ft)){$&&xt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(K);let Nt=st.update(w),Bt=w.material;Bt.visible&&C.push(w,Nt,Bt,nt,xt.z,null,G)}}else if(w.isMesh||w.isLine||w.isPoints){let Ft=G.isArrayCamera?Ue:re;if(!w.frustumCulled||w.intersectsFrustum(Ft)){let Nt=st.update(w),Bt=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xt.copy(w.boundingSphere.center)):(Nt.boundingSphere===null&&Nt.computeBoundingSphere(),xt.copy(Nt.boundingSphere.center)),xt.applyMatrix4(w.matrixWorld).applyMatrix4(K)),Array.isArray(Bt)){let Kt=Nt.groups;for(let ue=0,xe=Kt.length;ue<xe;ue++){let $t=Kt[ue],ye=Bt[$t.materialIndex];ye&&ye.visible&&C.push(w,Nt,ye,nt,xt.z,$t,G)}}else Bt.visible&&C.push(w,Nt,Bt,nt,xt.z,null,G)}}}let Dt=w.children;for(let Ft=0,Nt=Dt.length;Ft<Nt;Ft++)es(Dt[Ft],G,nt,$)}function Po(w,G,nt,$){let{opaque:Z,transmissive:Dt,transparent:Ft}=w;A.setupLightsView(nt),Le===!0&&rt.setGlobalState(N.clippingPlanes,nt),$&&yt.viewport(it.copy($)),Z.length>0&&tn(Z,G,nt),Dt.length>0&&tn(Dt,G,nt),Ft.length>0&&tn(Ft,G,nt),yt.buffers.depth.setTest(!0),yt.buffers.depth.setMask(!0),yt.buffers.color.setMask(!0),yt.setPolygonOffset(!1)}function Mi(w,G,nt,$){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let $t=kt.has("EXT_color_buffer_half_float")||kt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new li(1,1,{generateMipmaps:!0,type:$t?Ui:Zn,minFilter:ys,samples:Math.max(4,Ut.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:we.workingColorSpace})}let Dt=A.state.transmissionRenderTarget[$.id],Ft=$.viewport||it;Dt.setSize(Ft.z*N.transmissionResolutionScale,Ft.w*N.transmissionResolutionScale);let Nt=N.getRenderTarget(),Bt=N.getActiveCubeFace(),Kt=N.getActiveMipmapLevel();N.setRenderTarget(Dt),N.getClearColor(tt),gt=N.getClearAlpha(),gt<1&&N.setClearColor(16777215,.5),N.clear(),_t&&F.render(nt);let ue=N.toneMapping;N.toneMapping=Ki;let xe=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),Le===!0&&rt.setGlobalState(N.clippingPlanes,$),tn(w,nt,$),Gt.updateMultisampleRenderTarget(Dt),Gt.updateRenderTargetMipmap(Dt),kt.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let ye=0,je=G.length;ye<je;ye++){let Fe=G[ye],{object:Oe,geometry:pn,material:Wt,group:ln}=Fe;if(Wt.side===Yn&&Oe.layers.test($.layers)){let Me=Wt.side;Wt.side=qn,Wt.needsUpdate=!0,rn(Oe,nt,$,pn,Wt,ln),Wt.side=Me,Wt.needsUpdate=!0,$t=!0}}$t===!0&&(Gt.updateMultisampleRenderTarget(Dt),Gt.updateRenderTargetMipmap(Dt))}N.setRenderTarget(Nt,Bt,Kt),N.setClearColor(tt,gt),xe!==void 0&&($.viewport=xe),N.toneMapping=ue}function tn(w,G,nt){let $=G.isScene===!0?G.overrideMaterial:null;for(let Z=0,Dt=w.length;Z<Dt;Z++){let Ft=w[Z],{object:Nt,geometry:Bt,group:Kt}=Ft,ue=Ft.material;ue.allowOverride===!0&&$!==null&&(ue=$),Nt.layers.test(nt.layers)&&rn(Nt,G,nt,Bt,ue,Kt)}}function rn(w,G,nt,$,Z,Dt){z!==null&&Z.isNodeMaterial&&z.setObject(w,Z),w.onBeforeRender(N,G,nt,$,Z,Dt),w.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(N,G,nt,$,w,Dt),Z.transparent===!0&&Z.side===Yn&&Z.forceSinglePass===!1?(Z.side=qn,Z.needsUpdate=!0,N.renderBufferDirect(nt,G,$,Z,w,Dt),Z.side=qs,Z.needsUpdate=!0,N.renderBufferDirect(nt,G,$,Z,w,Dt),Z.side=Yn):N.renderBufferDirect(nt,G,$,Z,w,Dt),w.onAfterRender(N,G,nt,$,Z,Dt)}function on(w){let G=0;for(let nt of w)nt.texture!==null&&G++;return G}function Bi(w,G,nt){G.isScene!==!0&&(G=bt);let $=Et.get(w),Z=A.state.lights,Dt=A.state.shadowsArray,Ft=Z.state.version,Nt=Q.getParameters(w,Z.state,Dt,G,nt,A.state.lightProbeGridArray),Bt=Q.getProgramCacheKey(Nt),Kt=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?G.environment:null,$.fog=G.fog;let ue=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=T.get(w.envMap||$.environment,ue),$.envMapRotation=$.environment!==null&&w.envMap===null?G.environmentRotation:w.envMapRotation,Kt===void 0&&(w.addEventListener("dispose",ae),Kt=new Map,$.programs=Kt,$.programVariants=new Map);let xe=Kt.get(Bt);if(xe!==void 0){if($.currentProgram===xe&&$.lightsStateVersion===Ft)return Io(w,Nt),xe}else Nt.uniforms=Q.getUniforms(w),z!==null&&w.isNodeMaterial&&z.build(w,nt,Nt),w.onBeforeCompile(Nt,N),xe=Q.acquireProgram(Nt,Bt),Kt.set(Bt,xe),$.uniforms=Nt.uniforms;let $t=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&($t.clippingPlanes=rt.uniform),Io(w,Nt),$.needsLights=Ts(w),$.lightsStateVersion=Ft,$.needsLights&&($t.ambientLightColor.value=Z.state.ambient,$t.lightProbe.value=Z.state.probe,$t.sunLights.value=Z.state.sun,$t.sunLightShadows.value=Z.state.sunShadow,$t.directionalLights.value=Z.state.directional,$t.directionalLightShadows.value=Z.state.directionalShadow,$t.spotLights.value=Z.state.spot,$t.spotLightShadows.value=Z.state.spotShadow,$t.rectAreaLights.value=Z.state.rectArea,$t.ltc_1.value=Z.state.rectAreaLTC1,$t.ltc_2.value=Z.state.rectAreaLTC2,$t.pointLights.value=Z.state.point,$t.pointLightShadows.value=Z.state.pointShadow,$t.hemisphereLights.value=Z.state.hemi,$t.sunShadowMatrix.value=Z.state.sunShadowMatrix,$t.sunShadowCascade.value=Z.state.sunShadowCascade,$t.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,$t.spotLightMatrix.value=Z.state.spotLightMatrix,$t.spotLightMap.value=Z.state.spotLightMap,$t.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=on(A.state.lightProbeGridArray),$.currentProgram=xe,$.uniformsList=null,xe}function Kn(w,G,nt,$,Z){let Dt=Et.get(w),Ft=Dt.currentProgram.id+","+$+","+Z,Nt=Dt.programVariants.get(Ft);return Nt===void 0?(Nt=Bi(w,G,nt),Dt.programVariants.set(Ft,Nt)):(Dt.currentProgram=Nt,Dt.uniformsList=null,Dt.outputColorSpace=$,Dt.toneMapping=Z),Nt}function Es(w){if(w.uniformsList===null){let G=w.currentProgram.getUniforms();w.uniformsList=To.seqWithValue(G.seq,w.uniforms)}return w.uniformsList}function Io(w,G){let nt=Et.get(w);nt.outputColorSpace=G.outputColorSpace,nt.batching=G.batching,nt.batchingColor=G.batchingColor,nt.instancing=G.instancing,nt.instancingColor=G.instancingColor,nt.instancingMorph=G.instancingMorph,nt.skinning=G.skinning,nt.morphTargets=G.morphTargets,nt.morphNormals=G.morphNormals,nt.morphColors=G.morphColors,nt.morphTargetsCount=G.morphTargetsCount,nt.numClippingPlanes=G.numClippingPlanes,nt.numIntersection=G.numClipIntersection,nt.vertexAlphas=G.vertexAlphas,nt.vertexTangents=G.vertexTangents,nt.toneMapping=G.toneMapping}function Lo(w,G,nt,$,Z){G.isScene!==!0&&(G=bt),Gt.resetTextureUnits();let Dt=G.fog,Ft=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?G.environment:null,Nt=ct===null?N.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:we.workingColorSpace,Bt=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Kt=T.get($.envMap||Ft,Bt),ue=$.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,xe=!!nt.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),$t=!!nt.morphAttributes.position,ye=!!nt.morphAttributes.normal,je=!!nt.morphAttributes.color,Fe=Ki;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Fe=N.toneMapping);let Oe=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,pn=Oe!==void 0?Oe.length:0,Wt=Et.get($),ln=A.state.lights;if(Le===!0&&(We===!0||w!==j)){let Be=w===j&&$.id===Y;rt.setState($,w,Be)}let Me=!1,ns=!1;$.version===Wt.__version?Wt.needsLights&&Wt.lightsStateVersion!==ln.state.version||Z.isBatchedMesh&&Wt.batching===!1||!Z.isBatchedMesh&&Wt.batching===!0||Z.isBatchedMesh&&Wt.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Wt.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Wt.instancing===!1||!Z.isInstancedMesh&&Wt.instancing===!0||Z.isSkinnedMesh&&Wt.skinning===!1||!Z.isSkinnedMesh&&Wt.skinning===!0||Z.isInstancedMesh&&Wt.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Wt.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Wt.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Wt.instancingMorph===!1&&Z.morphTexture!==null||Wt.envMap!==Kt||$.fog===!0&&Wt.fog!==Dt||Wt.numClippingPlanes!==void 0&&(Wt.numClippingPlanes!==rt.numPlanes||Wt.numIntersection!==rt.numIntersection)||Wt.vertexAlphas!==ue||Wt.vertexTangents!==xe||Wt.morphTargets!==$t||Wt.morphNormals!==ye||Wt.morphColors!==je||Wt.morphTargetsCount!==pn||Wt.numLightProbeGrids!==on(A.state.lightProbeGridArray)?Me=!0:(Wt.outputColorSpace!==Nt||Wt.toneMapping!==Fe)&&(ns=!0):(Me=!0,Wt.__version=$.version);let cn=Wt.currentProgram;(Me===!0||ns===!0)&&(cn=ns===!0?Kn($,G,Z,Nt,Fe):Bi($,G,Z),z&&$.isNodeMaterial&&z.onUpdateProgram($,cn,Wt));let Sr=!1,zi=!1,is=!1,ge=cn.getUniforms(),en=Wt.uniforms;if(yt.useProgram(cn.program)&&(Sr=!0,zi=!0,is=!0),$.id!==Y&&(Y=$.id,zi=!0),Sr||j!==w){yt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),ge.setValue(P,"projectionMatrix",w.projectionMatrix),ge.setValue(P,"viewMatrix",w.matrixWorldInverse);let hn=ge.map.cameraPosition;hn!==void 0&&hn.setValue(P,dt.setFromMatrixPosition(w.matrixWorld)),Ut.logarithmicDepthBuffer&&ge.setValue(P,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ge.setValue(P,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,zi=!0,is=!0)}if(Wt.needsLights&&(ln.state.sunShadowMap.length>0&&ge.setValue(P,"sunShadowMap",ln.state.sunShadowMap,Gt),ln.state.directionalShadowMap.length>0&&ge.setValue(P,"directionalShadowMap",ln.state.directionalShadowMap,Gt),ln.state.spotShadowMap.length>0&&ge.setValue(P,"spotShadowMap",ln.state.spotShadowMap,Gt),ln.state.pointShadowMap.length>0&&ge.setValue(P,"pointShadowMap",ln.state.pointShadowMap,Gt)),Z.isSkinnedMesh){ge.setOptional(P,Z,"bindMatrix"),ge.setOptional(P,Z,"bindMatrixInverse");let Be=Z.skeleton;Be&&(Be.boneTexture===null&&Be.computeBoneTexture(),ge.setValue(P,"boneTexture",Be.boneTexture,Gt))}Z.isBatchedMesh&&(ge.setOptional(P,Z,"batchingTexture"),ge.setValue(P,"batchingTexture",Z._matricesTexture,Gt),ge.setOptional(P,Z,"batchingIdTexture"),ge.setValue(P,"batchingIdTexture",Z._indirectTexture,Gt),ge.setOptional(P,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ge.setValue(P,"batchingColorTexture",Z._colorsTexture,Gt));let Fn=nt.morphAttributes;if((Fn.position!==void 0||Fn.normal!==void 0||Fn.color!==void 0)&&at.update(Z,nt,cn),(zi||Wt.receiveShadow!==Z.receiveShadow)&&(Wt.receiveShadow=Z.receiveShadow,ge.setValue(P,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&G.environment!==null&&(en.envMapIntensity.value=G.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=nE()),zi){if(ge.setValue(P,"toneMappingExposure",N.toneMappingExposure),Wt.needsLights&&yr(en,is),Dt&&$.fog===!0&&mt.refreshFogUniforms(en,Dt),mt.refreshMaterialUniforms(en,$,At,Lt,A.state.transmissionRenderTarget[w.id]),Wt.needsLights&&Wt.numLightProbeGrids>0){let Be=v,hn=0;for(let Ln of A.state.lightProbeGridArray)Ln.texture!==null&&(Be.textures[hn]=Ln.texture,Be.min[hn]=Ln.boundingBox.min,Be.max[hn]=Ln.boundingBox.max,Be.resolution[hn]=Ln.resolution,hn++);for(let Ln in Be)Be[Ln].length=hn;en.probesSH.value=Be.textures,en.probesMin.value=Be.min,en.probesMax.value=Be.max,en.probesResolution.value=Be.resolution}To.upload(P,Es(Wt),en,Gt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(To.upload(P,Es(Wt),en,Gt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ge.setValue(P,"center",Z.center),ge.setValue(P,"modelViewMatrix",Z.modelViewMatrix),ge.setValue(P,"normalMatrix",Z.normalMatrix),ge.setValue(P,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Be=$.uniformsGroups;for(let hn=0,Ln=Be.length;hn<Ln;hn++){let Za=Be[hn];Qt.update(Za,cn),Qt.bind(Za,cn)}}return cn}function yr(w,G){w.ambientLightColor.needsUpdate=G,w.lightProbe.needsUpdate=G,w.sunLights.needsUpdate=G,w.sunLightShadows.needsUpdate=G,w.directionalLights.needsUpdate=G,w.directionalLightShadows.needsUpdate=G,w.pointLights.needsUpdate=G,w.pointLightShadows.needsUpdate=G,w.spotLights.needsUpdate=G,w.spotLightShadows.needsUpdate=G,w.rectAreaLights.needsUpdate=G,w.hemisphereLights.needsUpdate=G}function Ts(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,G,nt){let $=Et.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Et.get(w.texture).__webglTexture=G,Et.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:nt,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,G){let nt=Et.get(w);nt.__webglFramebuffer=G,nt.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(w,G=0,nt=0){ct=w,q=G,H=nt;let $=null,Z=!1,Dt=!1;if(w){let Nt=Et.get(w);if(Nt.__useDefaultFramebuffer!==void 0){yt.bindFramebuffer(P.FRAMEBUFFER,Nt.__webglFramebuffer),it.copy(w.viewport),pt.copy(w.scissor),ht=w.scissorTest,yt.viewport(it),yt.scissor(pt),yt.setScissorTest(ht),Y=-1;return}else if(Nt.__webglFramebuffer===void 0)Gt.setupRenderTarget(w);else if(Nt.__hasExternalTextures)Gt.rebindTextures(w,Et.get(w.texture).__webglTexture,Et.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let ue=w.depthTexture;if(Nt.__boundDepthTexture!==ue){if(ue!==null&&Et.has(ue)&&(w.width!==ue.image.width||w.height!==ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Gt.setupDepthRenderbuffer(w)}}let Bt=w.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(Dt=!0);let Kt=Et.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Kt[G])?$=Kt[G][nt]:$=Kt[G],Z=!0):w.samples>0&&Gt.useMultisampledRTT(w)===!1?$=Et.get(w).__webglMultisampledFramebuffer:Array.isArray(Kt)?$=Kt[nt]:$=Kt,it.copy(w.viewport),pt.copy(w.scissor),ht=w.scissorTest}else it.copy(Jt).multiplyScalar(At).floor(),pt.copy(de).multiplyScalar(At).floor(),ht=fe;if(nt!==0&&($=W),yt.bindFramebuffer(P.FRAMEBUFFER,$)&&yt.drawBuffers(w,$),yt.viewport(it),yt.scissor(pt),yt.setScissorTest(ht),Z){let Nt=Et.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_CUBE_MAP_POSITIVE_X+G,Nt.__webglTexture,nt)}else if(Dt){let Nt=G;for(let Bt=0;Bt<w.textures.length;Bt++){let Kt=Et.get(w.textures[Bt]);P.framebufferTextureLayer(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0+Bt,Kt.__webglTexture,nt,Nt)}}else if(w!==null&&nt!==0){let Nt=Et.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,Nt.__webglTexture,nt)}Y=-1};function vr(w){let G=Et.get(w);return(G.__readFormat!==w.format||G.__readType!==w.type)&&(G.__readFormat=w.format,G.__readType=w.type,G.__formatReadable=Ut.textureFormatReadable(w.format),G.__typeReadable=Ut.textureTypeReadable(w.type)),G}this.readRenderTargetPixels=function(w,G,nt,$,Z,Dt,Ft,Nt=0){if(!(w&&w.isWebGLRenderTarget)){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Et.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Ft!==void 0&&(Bt=Bt[Ft],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){yt.bindFramebuffer(P.FRAMEBUFFER,Bt);try{let Kt=w.textures[Nt],ue=Kt.format,xe=Kt.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Nt);let $t=vr(Kt);if($t.__formatReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($t.__typeReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=w.width-$&&nt>=0&&nt<=w.height-Z&&P.readPixels(G,nt,$,Z,Tt.convert(ue),Tt.convert(xe),Dt)}finally{let Kt=ct!==null?Et.get(ct).__webglFramebuffer:null;yt.bindFramebuffer(P.FRAMEBUFFER,Kt)}}},this.readRenderTargetPixelsAsync=async function(w,G,nt,$,Z,Dt,Ft,Nt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Et.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Ft!==void 0&&(Bt=Bt[Ft],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(G>=0&&G<=w.width-$&&nt>=0&&nt<=w.height-Z){yt.bindFramebuffer(P.FRAMEBUFFER,Bt);let Kt=w.textures[Nt],ue=Kt.format,xe=Kt.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Nt);let $t=vr(Kt);if($t.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($t.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ye=P.createBuffer();P.bindBuffer(P.PIXEL_PACK_BUFFER,ye),P.bufferData(P.PIXEL_PACK_BUFFER,Dt.byteLength,P.STREAM_READ),P.readPixels(G,nt,$,Z,Tt.convert(ue),Tt.convert(xe),0),P.bindBuffer(P.PIXEL_PACK_BUFFER,null);let je=ct!==null?Et.get(ct).__webglFramebuffer:null;yt.bindFramebuffer(P.FRAMEBUFFER,je);let Fe=P.fenceSync(P.SYNC_GPU_COMMANDS_COMPLETE,0);return P.flush(),await Ug(P,Fe,4),P.bindBuffer(P.PIXEL_PACK_BUFFER,ye),P.getBufferSubData(P.PIXEL_PACK_BUFFER,0,Dt),P.bindBuffer(P.PIXEL_PACK_BUFFER,null),P.deleteBuffer(ye),P.deleteSync(Fe),Dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,G=null,nt=0){let $=Math.pow(2,-nt),Z=Math.floor(w.image.width*$),Dt=Math.floor(w.image.height*$),Ft=G!==null?G.x:0,Nt=G!==null?G.y:0;Gt.setTexture2D(w,0),P.copyTexSubImage2D(P.TEXTURE_2D,nt,0,0,Ft,Nt,Z,Dt),yt.unbindTexture()},this.copyTextureToTexture=function(w,G,nt=null,$=null,Z=0,Dt=0){let Ft,Nt,Bt,Kt,ue,xe,$t,ye,je,Fe=w.isCompressedTexture?w.mipmaps[Dt]:w.image;if(nt!==null)Ft=nt.max.x-nt.min.x,Nt=nt.max.y-nt.min.y,Bt=nt.isBox3?nt.max.z-nt.min.z:1,Kt=nt.min.x,ue=nt.min.y,xe=nt.isBox3?nt.min.z:0;else{let ge=Math.pow(2,-Z);Ft=Math.floor(Fe.width*ge),Nt=Math.floor(Fe.height*ge),w.isDataArrayTexture?Bt=Fe.depth:w.isData3DTexture?Bt=Math.floor(Fe.depth*ge):Bt=1,Kt=0,ue=0,xe=0}$!==null?($t=$.x,ye=$.y,je=$.z):($t=0,ye=0,je=0);let Oe=Tt.convert(G.format),pn=Tt.convert(G.type),Wt;G.isData3DTexture?(Gt.setTexture3D(G,0),Wt=P.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Gt.setTexture2DArray(G,0),Wt=P.TEXTURE_2D_ARRAY):(Gt.setTexture2D(G,0),Wt=P.TEXTURE_2D),yt.activeTexture(P.TEXTURE0),yt.pixelStorei(P.UNPACK_FLIP_Y_WEBGL,G.flipY),yt.pixelStorei(P.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),yt.pixelStorei(P.UNPACK_ALIGNMENT,G.unpackAlignment);let ln=yt.getParameter(P.UNPACK_ROW_LENGTH),Me=yt.getParameter(P.UNPACK_IMAGE_HEIGHT),ns=yt.getParameter(P.UNPACK_SKIP_PIXELS),cn=yt.getParameter(P.UNPACK_SKIP_ROWS),Sr=yt.getParameter(P.UNPACK_SKIP_IMAGES);yt.pixelStorei(P.UNPACK_ROW_LENGTH,Fe.width),yt.pixelStorei(P.UNPACK_IMAGE_HEIGHT,Fe.height),yt.pixelStorei(P.UNPACK_SKIP_PIXELS,Kt),yt.pixelStorei(P.UNPACK_SKIP_ROWS,ue),yt.pixelStorei(P.UNPACK_SKIP_IMAGES,xe);let zi=w.isDataArrayTexture||w.isData3DTexture,is=G.isDataArrayTexture||G.isData3DTexture;if(w.isDepthTexture){let ge=Et.get(w),en=Et.get(G),Fn=Et.get(ge.__renderTarget),Be=Et.get(en.__renderTarget);yt.bindFramebuffer(P.READ_FRAMEBUFFER,Fn.__webglFramebuffer),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,Be.__webglFramebuffer);for(let hn=0;hn<Bt;hn++)zi&&(P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Et.get(w).__webglTexture,Z,xe+hn),P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Et.get(G).__webglTexture,Dt,je+hn)),P.blitFramebuffer(Kt,ue,Kt+Ft,ue+Nt,$t,ye,$t+Ft,ye+Nt,P.DEPTH_BUFFER_BIT,P.NEAREST);yt.bindFramebuffer(P.READ_FRAMEBUFFER,null),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Et.has(w)){let ge=Et.get(w),en=Et.get(G);yt.bindFramebuffer(P.READ_FRAMEBUFFER,L),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,V);for(let Fn=0;Fn<Bt;Fn++)zi?P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,ge.__webglTexture,Z,xe+Fn):P.framebufferTexture2D(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,ge.__webglTexture,Z),is?P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,en.__webglTexture,Dt,je+Fn):P.framebufferTexture2D(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,en.__webglTexture,Dt),Z!==0?P.blitFramebuffer(Kt,ue,Kt+Ft,ue+Nt,$t,ye,$t+Ft,ye+Nt,P.COLOR_BUFFER_BIT,P.NEAREST):is?P.copyTexSubImage3D(Wt,Dt,$t,ye,je+Fn,Kt,ue,Ft,Nt):P.copyTexSubImage2D(Wt,Dt,$t,ye,Kt,ue,Ft,Nt);yt.bindFramebuffer(P.READ_FRAMEBUFFER,null),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else is?w.isDataTexture||w.isData3DTexture?P.texSubImage3D(Wt,Dt,$t,ye,je,Ft,Nt,Bt,Oe,pn,Fe.data):G.isCompressedArrayTexture?P.compressedTexSubImage3D(Wt,Dt,$t,ye,je,Ft,Nt,Bt,Oe,Fe.data):P.texSubImage3D(Wt,Dt,$t,ye,je,Ft,Nt,Bt,Oe,pn,Fe):w.isDataTexture?P.texSubImage2D(P.TEXTURE_2D,Dt,$t,ye,Ft,Nt,Oe,pn,Fe.data):w.isCompressedTexture?P.compressedTexSubImage2D(P.TEXTURE_2D,Dt,$t,ye,Fe.width,Fe.height,Oe,Fe.data):P.texSubImage2D(P.TEXTURE_2D,Dt,$t,ye,Ft,Nt,Oe,pn,Fe);yt.pixelStorei(P.UNPACK_ROW_LENGTH,ln),yt.pixelStorei(P.UNPACK_IMAGE_HEIGHT,Me),yt.pixelStorei(P.UNPACK_SKIP_PIXELS,ns),yt.pixelStorei(P.UNPACK_SKIP_ROWS,cn),yt.pixelStorei(P.UNPACK_SKIP_IMAGES,Sr),Dt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&P.generateMipmap(Wt),yt.unbindTexture()},this.initRenderTarget=function(w){Et.get(w).__webglFramebuffer===void 0&&Gt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Gt.setTextureCube(w,0):w.isData3DTexture?Gt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Gt.setTexture2DArray(w,0):Gt.setTexture2D(w,0),yt.unbindTexture()},this.resetState=function(){q=0,H=0,ct=null,yt.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=we._getDrawingBufferColorSpace(t),e.unpackColorSpace=we._getUnpackColorSpace()}};function v0(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let v=0;v<s;v++)r[3*v+0]=n.getX(v),r[3*v+1]=n.getY(v),r[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let C=9*v,A=r[C+0],_=r[C+1],E=r[C+2],B=r[C+3],N=r[C+4],D=r[C+5],z=r[C+6],W=r[C+7],L=r[C+8],V=z-B,q=W-N,H=L-D,ct=A-B,Y=_-N,j=E-D,it=q*j-H*Y,pt=H*ct-V*j,ht=V*Y-q*ct,tt=1/(Math.sqrt(it*it+pt*pt+ht*ht)||1);c[3*v+0]=it*tt,c[3*v+1]=pt*tt,c[3*v+2]=ht*tt}let h=new Int32Array(s),d=new Float64Array(s*3),u=1;for(;u<s*2;)u<<=1;let p=u-1,g=new Int32Array(u),S=0;for(let v=0;v<s;v++){let C=3*v,A=Math.trunc(r[C+0]*a),_=Math.trunc(r[C+1]*a),E=Math.trunc(r[C+2]*a),B=(Math.imul(A,73856093)^Math.imul(_,19349663)^Math.imul(E,83492791))&p;for(;;){let N=g[B];if(N===0){let z=3*S;d[z+0]=A,d[z+1]=_,d[z+2]=E,g[B]=S+1,h[v]=S++;break}let D=3*(N-1);if(d[D+0]===A&&d[D+1]===_&&d[D+2]===E){h[v]=N-1;break}B=B+1&p}}let m=new Int32Array(S+1);for(let v=0;v<s;v++)m[h[v]+1]++;for(let v=0;v<S;v++)m[v+1]+=m[v];let f=new Int32Array(s),M=m.slice(0,S);for(let v=0;v<l;v++){let C=3*v;f[M[h[C+0]]++]=v,f[M[h[C+1]]++]=v,f[M[h[C+2]]++]=v}let R=new Float32Array(s*3);for(let v=0;v<l;v++){let C=3*v,A=c[C+0],_=c[C+1],E=c[C+2];for(let B=0;B<3;B++){let N=C+B,D=h[N],z=0,W=0,L=0;for(let q=m[D],H=m[D+1];q<H;q++){let ct=3*f[q],Y=c[ct+0],j=c[ct+1],it=c[ct+2];A*Y+_*j+E*it>o&&(z+=Y,W+=j,L+=it)}let V=1/(Math.sqrt(z*z+W*W+L*L)||1);R[3*N+0]=z*V,R[3*N+1]=W*V,R[3*N+2]=L*V}}return e.setAttribute("normal",new An(R,3,!1)),e}var iE=Math.PI/6;async function S0(i){let t=new DataView((await Tu(i.data)).buffer),e=new Float32Array(3*i.points);for(let r=0;r<e.length;++r)e[r]=i.low[r%3]+i.step[r%3]*t.getUint16(2*r,!0);let n=new Uint16Array(3*i.triangles);for(let r=0;r<n.length;++r)n[r]=t.getUint16(2*(e.length+r),!0);let s=new Qe;return s.setAttribute("position",new An(e,3)),s.setIndex(new An(n,1)),v0(s,iE)}var M0=new Map;function yh(i,t){let e=M0.get(i)??t();return M0.set(i,e),e}function Ms(i,t=1){return yh(`cylinder ${t} ${i}`,()=>new _a(t,1,1,i).rotateX(Math.PI/2).translate(0,0,.5))}function jd(i){return yh(`ball ${i}`,()=>new ya(1,i,Math.round(.625*i)))}function b0(i){return yh(`quarters ${i}`,()=>{let t=jd(i).toNonIndexed(),e=t.getAttribute("position"),n=[];for(let s=0;s<e.count;s+=3){let r=1;for(let o of[0,1,2])r*=Math.sign([0,1,2].reduce((a,l)=>a+e.getComponent(s+l,o),0));for(let o=0;o<9;++o)n.push(r<0?1:.72)}return t.setAttribute("color",new ze(n,3)),t})}function Qd(i,t,e){return yh(`ring ${i} ${t} ${e}`,()=>new hr(1,i,t,e))}var Jd=9,Kd=16,ui=6,ka=.08;function w0(){let i=Jd*Kd+5,t=[];for(let n=0;n+1<i;++n)if(!(n===1||n===i-3))for(let s=0;s<ui;++s){let[r,o]=[n*ui+s,n*ui+(s+1)%ui];t.push(r,r+ui,o,o,r+ui,o+ui)}let e=new Qe;e.setIndex(t);for(let n of["position","normal"])e.setAttribute(n,new ze(new Float32Array(3*i*ui),3));return e}function E0(i,t,e,n){let s=Jd*Kd,r=i.getAttribute("position"),o=i.getAttribute("normal"),a=(1-2*ka)*t,l=a/(2*Math.PI*Jd*e),c=Math.hypot(1,l),h=(g,S,m,f)=>{for(let M=0;M<ui;++M){let[R,v]=[Math.cos(2*Math.PI*M/ui),Math.sin(2*Math.PI*M/ui)],[C,A,_]=[R*m.x+v*f.x,R*m.y+v*f.y,R*m.z+v*f.z];o.setXYZ(g*ui+M,C,A,_),r.setXYZ(g*ui+M,S.x+n*C,S.y+n*A,S.z+n*_)}},[d,u,p]=[new O,new O,new O];for(let g=0;g<=s;++g){let S=2*Math.PI*g/Kd;u.set(Math.sin(S),-Math.cos(S),0),p.set(-l*Math.cos(S)/c,-l*Math.sin(S)/c,1/c),d.copy(u).multiplyScalar(e).setZ(ka*t+a*g/s),h(g+2,d,u,p)}p.set(-1,0,0);for(let[g,S]of[[0,-1],[s+3,1]]){let[m,f]=S<0?[0,ka*t]:[(1-ka)*t,t];u.set(0,-ka*t,S*e).normalize(),h(g,d.set(0,S<0?0:-e,m),u,p),h(g+1,d.set(0,S<0?-e:0,f),u,p)}r.needsUpdate=o.needsUpdate=!0,i.computeBoundingBox(),i.computeBoundingSphere()}var Zd=new O,Ga=new O;function vi(i,t,e,n=e){let s=new O().subVectors(t,i),r=s.length(),o=r>0?s.clone().divideScalar(r):new O(0,0,1);return Ga.set(0,1,0),Math.abs(o.y)>.9&&Ga.set(1,0,0),Zd.crossVectors(Ga,o).normalize(),Ga.crossVectors(o,Zd),new me().makeBasis(Zd.clone().multiplyScalar(e),Ga.clone().multiplyScalar(n),o.multiplyScalar(Math.max(r,1e-12))).setPosition(i)}function T0(i){let t=[[i[0],i[3],i[4]],[i[3],i[1],i[5]],[i[4],i[5],i[2]]],e=[[1,0,0],[0,1,0],[0,0,1]];for(let n=0;n<20;++n)for(let[s,r]of[[0,1],[0,2],[1,2]]){if(Math.abs(t[s][r])<1e-300)continue;let o=(t[r][r]-t[s][s])/(2*t[s][r]),a=Math.sign(o||1)/(Math.abs(o)+Math.sqrt(o*o+1)),l=1/Math.sqrt(a*a+1),c=a*l;for(let h=0;h<3;++h)[t[h][s],t[h][r]]=[l*t[h][s]-c*t[h][r],c*t[h][s]+l*t[h][r]];for(let h=0;h<3;++h)[t[s][h],t[r][h]]=[l*t[s][h]-c*t[r][h],c*t[s][h]+l*t[r][h]],[e[h][s],e[h][r]]=[l*e[h][s]-c*e[h][r],c*e[h][s]+l*e[h][r]]}return{values:[t[0][0],t[1][1],t[2][2]],axes:[0,1,2].map(n=>[e[0][n],e[1][n],e[2][n]])}}function A0([i,t,e,n,s,r],o){let a=Math.max(...[i,t,n,s,r].map(Math.abs)),l=Math.hypot(o.x,o.y);if(!(a<=1e-9*e&&e>0&&l>0&&Math.abs(o.z)<=1e-9*l))return null;let[c,h]=[o.x/l,o.y/l];return[[c,h,0],[-h,c,0],[0,0,1]]}function Si(i,t){return Math.max(6,Math.round(t*i.detail))}var sE=.55,rE={rod:6583435,rope:6583435,spring:889992,damper:8141549,mass:2450411,body:3900150,box:3900150,cylinder:6333946,cone:3900150,disc:3900150,sphere:2450411,circle:4674921,mesh:9741240,arrow:14251782,force:14427686,torque:15357964,trace:14251782,slider:2450411,dial:2450411,ground:9741240,velocity:1483594,acceleration:9647082,admissible:14362487,reaction:165063,"reaction torque":947344,constraint:11817737,friction:12592851};function ef(i){let t=i.texts.color;return t!==void 0&&CSS.supports("color",t)?t:rE[i.kind]??6583435}function fi(i,t){let e=new Li({color:ef(i)}),n=new an(t,e);return n.matrixAutoUpdate=!1,n}function Ee(i,t,e){let n=e.first+i.numbers[t];return new O(e.numbers[n],e.numbers[n+1],e.numbers[n+2])}function di(i,t,e,n){let s=i.numbers[t];return s===void 0?n:e.numbers[e.first+s]}function sf(i,t){return"x"in i.numbers?[Ee(i,"x",t),Ee(i,"y",t),Ee(i,"z",t)]:[new O(1,0,0),new O(0,1,0),new O(0,0,1)]}function Va(i,t,e,n,s){let[r,o,a]=sf(i,t);return new me().makeBasis(r.multiplyScalar(e),o.multiplyScalar(n),a.multiplyScalar(s)).setPosition(Ee(i,"at",t))}function oE(i,t){let[e,n,s]=sf(i,t);if(!i.vectors.includes("axis"))return s;let r=Ee(i,"axis",t),o=e.multiplyScalar(r.x).addScaledVector(n,r.y).addScaledVector(s,r.z);return o.lengthSq()>0?o.normalize():new O(0,0,1)}function C0(i,t,e,n){let s=fi(i,e);return{object:s,shape:i,update(r){let o=di(i,"radius",r,n*t.length);s.matrix.copy(vi(Ee(i,"at",r),Ee(i,"to",r),o))}}}function aE(i,t){let e=w0(),n=fi(i,e);n.userData.bent=!0;let[s,r]=[0,0];return{object:n,shape:i,update(o){let[a,l]=[Ee(i,"at",o),Ee(i,"to",o)],c=di(i,"radius",o,.03*t.length),h=a.distanceTo(l);(h!==s||c!==r)&&E0(e,h,c,.16*c),[s,r]=[h,c],n.matrix.copy(vi(a,l,1)).scale(new O(1,1,1/Math.max(h,1e-12)))}}}function lE(i,t){let e=new Pn,n=fi(i,Ms(Si(t,24))),s=fi(i,Ms(Si(t,24)));return e.add(n,s),{object:e,shape:i,update(r){let[o,a]=[Ee(i,"at",r),Ee(i,"to",r)];n.matrix.copy(vi(o,a,.005*t.length)),s.matrix.copy(vi(o.clone().lerp(a,.2),o.clone().lerp(a,.6),.016*t.length))}}}function R0(i,t){let e=fi(i,jd(Si(t,32)));return{object:e,shape:i,update(n){let s=di(i,"mass",n,t.mass),r=t.mass>0?Math.cbrt(Math.max(s,0)/t.mass):1,o=di(i,"radius",n,.04*t.length*Math.max(r,.25));e.matrix.copy(Va(i,n,o,o,o))}}}function cE(i,t){let e=fi(i,b0(Si(t,32)));return Object.assign(e.material,{transparent:!0,opacity:sE,depthWrite:!1,vertexColors:!0}),{object:e,shape:i,update(n){let s=di(i,"mass",n,1),r=n.first+i.numbers.inertia,{values:o,axes:a}=T0(Array.from(n.numbers.subarray(r,r+6))),l=o[0]+o[1]+o[2],c=.012*t.length,h=o.map(v=>{let C=2.5*(l-2*v)/s;return s>0&&C>0?Math.min(Math.max(Math.sqrt(C),c),t.length):c}),[d,u,p]=sf(i,n),g=v=>new O().addScaledVector(d,v[0]).addScaledVector(u,v[1]).addScaledVector(p,v[2]),S=Ee(i,"com",n),m=A0(Array.from(n.numbers.subarray(r,r+6)),S),f=Math.min(Math.sqrt(3*l/s),t.length),M=m?m.map((v,C)=>g(v).multiplyScalar(C===0?f:c)):a.map((v,C)=>g(v).multiplyScalar(h[C])),R=Ee(i,"at",n).add(g([S.x,S.y,S.z]));e.matrix.makeBasis(M[0],M[1],M[2]).setPosition(R)}}}function hE(i,t){let e=fi(i,new $n(1,1,1)),n=.09*t.length;return{object:e,shape:i,update(s){let r=di(i,"width",s,n),o=di(i,"height",s,n),[a,l]=t.planar?[o,r]:[r,o];if("to"in i.numbers){let[c,h]=[Ee(i,"at",s),Ee(i,"to",s)];e.matrix.copy(vi(c,h,a,l)).multiply(new me().makeTranslation(0,0,.5))}else if(i.vectors.includes("size")){let c=Ee(i,"size",s);e.matrix.copy(Va(i,s,c.x,c.y,c.z))}else{let c=di(i,"length",s,n);e.matrix.copy(Va(i,s,c,a,l))}}}}function nf(i,t,e){return(n,s)=>{let r=fi(n,Ms(Si(s,40),e));return{object:r,shape:n,update(o){let a=di(n,"radius",o,i*s.length),l=Ee(n,"at",o);if("to"in n.numbers){r.matrix.copy(vi(l,Ee(n,"to",o),a));return}let c=oE(n,o),h=di(n,"length",o,di(n,"height",o,t*a)),d=e===1,u=d?l.clone().addScaledVector(c,-h/2):l.clone().addScaledVector(c,h),p=d?l.clone().addScaledVector(c,h/2):l;r.matrix.copy(vi(u,p,a)),"x"in n.numbers&&uE(r.matrix,Ee(n,"x",o),a)}}}}function uE(i,t,e){let n=new O().setFromMatrixColumn(i,2),s=new O().setFromMatrixPosition(i),r=n.clone().normalize(),o=t.clone().addScaledVector(r,-t.dot(r));if(o.lengthSq()<1e-12)return;o.normalize();let a=new O().crossVectors(r,o);i.makeBasis(o.multiplyScalar(e),a.multiplyScalar(e),n).setPosition(s)}function dE(i,t){let e=nf(.1,.12,1)(i,t),n=new an(new $n(.9,.08,1.04).translate(.45,0,.5),new Li({color:16317180}));return e.object.add(n),e}function fE(i,t){let e="radius"in i.numbers,n=fi(i,e?Qd(.02,Si(t,12),64):Qd(.28,Si(t,8),Si(t,24)));return{object:n,shape:i,update(s){let r=di(i,"radius",s,.014*t.length);n.matrix.copy(Va(i,s,r,r,r))}}}function pE(i,t){let e=fi(i,t.meshes[i.mesh??-1]??new Qe);return e.material.side=Yn,{object:e,shape:i,update(n){let s=di(i,"scale",n,1),{x:r,y:o,z:a}=i.vectors.includes("scale")?Ee(i,"scale",n):new O(s,s,s);e.matrix.copy(Va(i,n,r,o,a))}}}var P0=i=>(t,e,n)=>Ee(t,"vector",e).multiplyScalar(n[i]),mE=(i,t,e)=>"vector"in i.numbers?Ee(i,"vector",t).normalize().multiplyScalar(.2*e.length):Ee(i,"to",t).sub(Ee(i,"at",t));function tf(i){return(t,e)=>{let n=new Pn,s=fi(t,Ms(Si(e,24))),r=fi(t,Ms(Si(e,24),.001));return n.add(s,r),{object:n,shape:t,update(o){let a=Ee(t,"at",o),l=i(t,o,e),c=l.length();if(n.visible=c>1e-6*e.length,!n.visible)return;let h=Math.min(.05*e.length,.6*c),d=a.clone().addScaledVector(l,1-h/c);s.matrix.copy(vi(a,d,.006*e.length)),r.matrix.copy(vi(d,a.clone().add(l),.018*e.length))}}}}function gE(i,t){let e=new Pn,n=new _s(new Qe,new zs({color:ef(i)})),s=new _s(n.geometry.clone(),new zs({color:ef(i),transparent:!0,opacity:.25}));n.frustumCulled=s.frustumCulled=!1,e.add(n,s);let r=null;return{object:e,shape:i,update(){},follow(o,a){if(o!==r){r=o;let l=new Float32Array(3*o.count),c=t.first+i.numbers.at;for(let h=0;h<o.count;++h)for(let d=0;d<3;++d)l[3*h+d]=o.at(h,c+d);for(let h of[n,s])h.geometry.dispose(),h.geometry=new Qe,h.geometry.setAttribute("position",new An(l,3))}n.geometry.setDrawRange(0,a+1)}}}function rf(i,t,e){let n=document.createElement("canvas"),s=n.getContext("2d"),r="48px system-ui, sans-serif";if(s===null)return new gs;s.font=r,n.width=Math.ceil(s.measureText(i).width)+16,n.height=64,s.font=r,s.fillStyle=e,s.textBaseline="middle",s.fillText(i,8,34);let o=new gs(new go({map:new pa(n),depthTest:!1}));return o.userData.words=i,o.scale.set(t*n.width/64,t,1),o}function _E(i,t){let e=rf(i.texts.text??i.name,.06*t.length,"#64748b");return{object:e,shape:i,update:n=>{e.position.copy(Ee(i,"at",n))}}}function xE(i,t){let e=new Pn,n=(i.name==="world"?.12:.07)*t.length,r=[14427686,1483594,2450411].map(o=>{let a=new an(Ms(8),new Li({color:o}));return a.matrixAutoUpdate=!1,e.add(a),a});return{object:e,shape:i,update(o){let a=Ee(i,"at",o);["x","y","z"].forEach((l,c)=>{let h=a.clone().addScaledVector(Ee(i,l,o),n);r[c].matrix.copy(vi(a,h,.03*n))})}}}function yE(i,t){let e=fi(i,new $n(1,1,1).translate(0,0,-.5)),n=null;return{object:e,shape:i,update(){},follow(s){if(s===n)return;n=s;let r={numbers:Float64Array.from({length:s.width},(d,u)=>s.at(0,u)),first:t.first},o=Ee(i,"normal",r),a=Ee(i,"at",r),l=t.center.clone().addScaledVector(o,o.dot(a.sub(t.center))),c=l.clone().addScaledVector(o,-1),h=1.3*t.length;e.matrix.copy(vi(c,l,h,h)).multiply(new me().makeTranslation(0,0,1)),e.matrix.multiply(new me().makeScale(1,1,.02*t.length))}}}var vh={rod:(i,t)=>C0(i,t,Ms(Si(t,24)),.007),rope:(i,t)=>C0(i,t,Ms(Si(t,24)),.004),spring:aE,damper:lE,box:hE,cylinder:nf(.03,2.4,1),cone:nf(.06,2,.001),disc:dE,sphere:R0,mass:R0,body:cE,circle:fE,mesh:pE,arrow:tf(mE),force:tf(P0("force")),torque:tf(P0("torque")),trace:gE,text:_E,frame:xE,ground:yE};var U0=[["velocity","v","Velocities of masses"],["acceleration","a","Accelerations of masses"],["admissible","\u2202r/\u2202q","Admissible motions of masses: each coordinate alone"],["reaction","reactions","Forces and torques of joints, rods and wires"],["constraint","constraints","Forces of constraints on masses"],["friction","friction","Dry friction: its forces, and whether it sticks or slides"]],vE={velocity:"m/s",acceleration:"m/s\xB2",reaction:"N","reaction torque":"N\xB7m",constraint:"N",friction:"N",force:"N",torque:"N\xB7m"},I0=["#db2777","#7c3aed","#0891b2","#65a30d","#ca8a04","#dc2626","#2563eb","#0d9488"],L0=.3,of=8,D0=1e-10,SE=["open","slides","sticks"],Sh=class{constructor(t,e,n){this.vectors=t;this.sizes=e;let s=t.shapes.flatMap(r=>r.texts.coordinate??[]);this.coordinates=[...new Set(s)];for(let r of t.shapes.filter(N0)){let o=this.coordinates.indexOf(r.texts.coordinate??"");o>=0&&(r.texts.color=I0[o%I0.length]);let a=this.scales.get(Ha(r))??{...e,first:t.first};this.scales.set(Ha(r),a);let l=vh.force(r,a);l.object.traverse(c=>c.userData.shape=r),l.object.visible=!1,this.drawn.push(l),n.add(l.object)}}vectors;sizes;drawn=[];shown=new Set;coordinates;coordinate="";scales=new Map;motion=null;row=0;largest=0;numbers=new Float64Array(0);has(t){return this.vectors.shapes.some(e=>af(e)===t)}take(t){this.motion=t,this.numbers=new Float64Array(t.width);let e=new Map;for(let n of this.vectors.shapes.filter(N0)){let s=this.vectors.first+n.numbers.vector;for(let r=0;r<t.count;++r){let o=Math.hypot(t.at(r,s),t.at(r,s+1),t.at(r,s+2));Number.isFinite(o)&&e.set(Ha(n),Math.max(e.get(Ha(n))??0,o))}}this.largest=0;for(let n of this.vectors.shapes.filter(({kind:s})=>s==="friction")){let s=this.vectors.first+n.numbers.value;this.largest=Math.max(this.largest,t.largest(s),n.texts.components==="2"?t.largest(s+1):0)}for(let[n,s]of this.scales){let r=e.get(n)??0,o=n.startsWith("reaction torque")?this.sizes.length*(e.get("reaction N")??0):0;s.force=r>D0*o?L0*this.sizes.length/r:0}}pose(t){if(this.motion!==null&&this.motion.count>0){let n=Math.min(t,this.motion.last);this.motion.state(n,this.numbers),this.row=this.motion.rowAt(n)}let e={numbers:this.numbers,first:this.vectors.first};for(let n of this.drawn){let s=this.coordinate===""||(n.shape.texts.coordinate??this.coordinate)===this.coordinate;this.shown.has(af(n.shape))&&s&&this.motion!==null?n.update(e):n.object.visible=!1,n.object.updateMatrixWorld(!0)}}value(t){if(t.kind==="friction")return this.rubs(t);let e=Ee(t,"vector",{numbers:this.numbers,first:this.vectors.first});return`${Wa(e.length())} ${Co(t)}`}legend(){let t=[];for(let[r,o]of this.scales){let a=this.vectors.shapes.find(l=>Ha(l)===r);a===void 0||!this.shown.has(af(a))||o.force===0||t.push(`${a.kind}: longest ${Wa(L0*this.sizes.length/o.force)} ${Co(a)}`)}if(!this.shown.has("friction")||this.motion===null)return t;let n=[...new Map(this.vectors.shapes.filter(({kind:r})=>r==="friction").map(r=>[r.name,r])).values()].map(r=>`${r.name}: ${this.rubs(r)}`),s=n.length>of?[`and ${n.length-of} more`]:[];return[...t,...n.slice(0,of),...s]}rubs(t){let{first:e}=this.vectors,n=SE[this.motion?.at(this.row,e+t.numbers.mode)??0]??"";if(n==="open")return n;let s=e+t.numbers.value,r=Math.hypot(...this.numbers.subarray(s,s+Number(t.texts.components)));return`${n}, ${Wa(r>D0*this.largest?r:0)} ${Co(t)}`}};function N0(i){return"vector"in i.numbers}function Co(i){return i.texts.unit??vE[i.kind]??""}function Wa(i){return Number(i.toPrecision(3)).toString()}function af(i){return i.kind==="reaction torque"?"reaction":i.kind}function Ha(i){return`${i.kind} ${Co(i)}`}var ME=[.1,.25,.5,1,2,4],bE=[1,60],wE=5;function EE(i){let[t,e]=bE;return i>=t&&i<=e?1:Number(zr(i/wE).toPrecision(1))}var Mh=class{constructor(t,e,n){this.moved=n;this.time=t.start,this.span=[t.start,t.stop],this.again=t.modes!==void 0,this.speed=this.again?1:EE(t.stop-t.start);let s=this.speed===1?ME:[...[.1,.2,.5,1,2,5].map(o=>o*this.speed),1];this.choices=[...new Set(s.map(o=>Number(o.toPrecision(3))))].sort((o,a)=>o-a),this.button=document.createElement("button"),this.button.className="play",this.button.onclick=()=>this.toggle(),this.bar=document.createElement("input"),Object.assign(this.bar,{type:"range",min:`${t.start}`,max:`${t.stop}`,step:"any",value:`${t.start}`}),this.bar.setAttribute("aria-label","Time"),this.bar.oninput=()=>this.go(Number(this.bar.value)),this.clock=document.createElement("output"),this.clock.className="clock",this.ticks=document.createElement("div"),this.ticks.className="ticks",this.ticks.setAttribute("aria-hidden","true");let r=document.createElement("div");r.className="track",r.append(this.ticks,this.bar),this.chooser=this.speeds(),e.append(this.button,r,this.clock,this.chooser),this.mark(t.events),this.show()}moved;time;speed;choices;pace=1;span;again;running=!1;before=0;bar;button;clock;ticks;chooser;over(t,e,n){let[s,r]=this.span,o=(this.time-s)/(r-s||1),a=s===t&&r===e;this.span=[t,e],this.pace=n,Object.assign(this.bar,{min:`${t}`,max:`${e}`}),a||(this.time=t+o*(e-t)),this.show()}faster(t){let e=Math.min(Math.max(this.choices.indexOf(this.speed)+t,0),this.choices.length-1);this.speed=this.choices[e],this.chooser.value=`${this.speed}`}speeds(){let t=document.createElement("select");t.setAttribute("aria-label","Speed");for(let e of this.choices)t.append(new Option(`${e}\xD7`,`${e}`,e===this.speed,e===this.speed));return t.onchange=()=>this.speed=Number(t.value),t}mark(t){let[e,n]=this.span;this.ticks.replaceChildren(...fl(t,e,n).map(({time:s,name:r,kind:o})=>{let a=document.createElement("i");return a.style.left=`${100*(s-e)/(n-e)}%`,a.title=`${r} ${o}`,a.className=o,a}))}toggle(){this.running?this.pause():this.play()}play(){this.time>=this.span[1]&&([this.time]=this.span),this.running=!0,this.before=performance.now(),requestAnimationFrame(t=>this.tick(t)),this.show()}pause(){this.running=!1,this.show()}go(t){this.time=Math.min(Math.max(t,this.span[0]),this.span[1]),this.show(),this.moved(this.time)}step(t){this.pause(),this.go(this.time+t*(this.span[1]-this.span[0]))}get digits(){return Math.min(Math.max(2-Math.floor(Math.log10((this.span[1]-this.span[0])/2)),2),9)}tick(t){if(!this.running)return;let e=this.time+(t-this.before)/1e3*this.speed*this.pace;if(this.before=t,e>=this.span[1]&&!this.again){this.go(this.span[1]),this.pause();return}this.go(e>=this.span[1]?this.span[0]:e),requestAnimationFrame(n=>this.tick(n))}show(){this.button.textContent=this.running?"\u275A\u275A":"\u25B6",this.button.setAttribute("aria-label",this.running?"Pause":"Play"),this.bar.value=`${this.time}`,this.clock.value=`${this.time.toFixed(this.digits)} s`}};var bs={left:62,right:10,top:8,bottom:34},TE="http://www.w3.org/2000/svg";function O0(i){let t=document.createElement("div");t.className="locus";let e=i.unit&&i.unit!=="1"?` [${i.unit}]`:"",[n,s]=[Math.min(...i.values),Math.max(...i.values)],r=(l,c)=>i.values.flatMap((h,d)=>i.eigenvalues[d].flatMap(u=>u===null?[]:[{x:l(h,u),y:c(u),part:(h-n)/(s-n||1),words:`${i.name} = ${h.toPrecision(4)}`}])),o=i.thresholds.map(l=>l.value);t.append(lf(r((l,c)=>c[0],l=>l[1]),"real part [1/s]","imaginary part [1/s]",[],!0),lf(r(l=>l,l=>l[0]),`${i.name}${e}`,"real part [1/s]",o,!1),lf(r(l=>l,l=>Math.abs(l[1])/(2*Math.PI)),`${i.name}${e}`,"frequency [Hz]",o,!1));let a=document.createElement("ul");for(let{value:l,kind:c,frequency:h,unstable_above:d}of i.thresholds){let u=document.createElement("li"),p=h>0?` at ${h.toPrecision(4)} Hz`:"";u.textContent=`${c}${p} ${d?"above":"below"} ${i.name} = ${l.toPrecision(6)} ${i.unit}`,a.append(u)}return i.thresholds.length>0&&t.append(a),t}function _r(i,t,e=""){let n=document.createElementNS(TE,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,`${r}`);return e!==""&&(n.textContent=e),n}function F0(i){let[t,e]=[Math.min(...i),Math.max(...i)],n=e>t?.06*(e-t):1;return[t-n,e+n]}function lf(i,t,e,n,s){let r=_r("svg",{viewBox:"0 0 420 200",role:"img","aria-label":`${e} over ${t}`}),[o,a]=F0([...i.map(g=>g.x),...s?[0]:[]]),[l,c]=F0([...i.map(g=>g.y),0]),h=g=>bs.left+(g-o)/(a-o)*(420-bs.left-bs.right),d=g=>200-bs.bottom-(g-l)/(c-l)*(200-bs.top-bs.bottom),u=(g,S,m)=>{r.append(_r("line",{x1:g[0],y1:g[1],x2:S[0],y2:S[1],class:m}))};u([h(o),d(0)],[h(a),d(0)],"axis"),s&&u([h(0),d(l)],[h(0),d(c)],"axis");for(let g of n)u([h(g),d(l)],[h(g),d(c)],"threshold");for(let g of i){let S=_r("circle",{cx:h(g.x).toFixed(2),cy:d(g.y).toFixed(2),r:2,fill:`hsl(${(230-190*g.part).toFixed(0)} 70% 50%)`});S.append(_r("title",{},g.words)),r.append(S)}let p=[[h(o),180,"start",o.toPrecision(3)],[h(a),180,"end",a.toPrecision(3)],[bs.left-4,d(l),"end",l.toPrecision(3)],[bs.left-4,d(c)+9,"end",c.toPrecision(3)]];for(let[g,S,m,f]of p)r.append(_r("text",{x:g,y:S,"text-anchor":m},f));return r.append(_r("text",{x:(bs.left+420)/2,y:194,"text-anchor":"middle"},t)),r.append(_r("text",{x:-200/2+10,y:12,"text-anchor":"middle",transform:"rotate(-90)"},e)),r}var bh=class{constructor(t,e,n){this.head=t;this.chosen=n;let s=document.createElement("section");s.id="runs",t.modes!==void 0?this.modes(s,t.modes):t.runs!==void 0&&t.runs.length>1&&this.sweep(s,t.runs.map(r=>r.label)),e.prepend(s)}head;chosen;level=0;mode=0;buttons=[];sweep(t,e){let n=document.createElement("label"),s=document.createElement("input");Object.assign(s,{type:"range",min:"0",max:`${e.length-1}`,step:"1",value:"0"}),s.setAttribute("aria-label","Run");let r=document.createElement("output"),o=()=>{let a=Number(s.value);r.textContent=`Run ${a+1} of ${e.length}: ${e[a]}`,s.setAttribute("aria-valuetext",r.textContent)};s.oninput=()=>{o(),this.chosen(Number(s.value))},o(),n.append(r,s),t.append(n)}modes(t,e){let n=this.head.levels??[""];this.level=Math.min(1,n.length-1);let s=document.createElement("p");s.textContent=this.head.stability??"";let r=document.createElement("div");r.className="modes",e.forEach((l,c)=>{let h=document.createElement("button");h.textContent=`${c+1}: ${AE(l)}`,h.onclick=()=>{this.mode=c,this.show(e,a)},this.buttons.push(h),r.append(h)});let o=document.createElement("select");o.setAttribute("aria-label","Amplitude"),n.forEach((l,c)=>o.append(new Option(`amplitude: ${l}`,`${c}`,c===this.level,c===this.level))),o.onchange=()=>{this.level=Number(o.value),this.show(e,a)};let a=document.createElement("table");a.className="shape",t.append(s,r,o,a),this.head.locus!=null&&t.append(O0(this.head.locus)),this.show(e,a)}get run(){return this.mode*(this.head.levels?.length??1)+this.level}show(t,e){this.buttons.forEach((r,o)=>r.ariaPressed=`${o===this.mode}`);let n=document.createElement("tr");n.innerHTML='<th scope="col">shape</th><th scope="col">size</th><th scope="col">phase</th>';let s=t[this.mode].shape.map(({name:r,size:o,phase:a})=>{let l=document.createElement("tr");for(let c of[r,o.toPrecision(3),o>1e-9?`${a.toFixed(0)}\xB0`:""]){let h=document.createElement("td");h.textContent=c,l.append(h)}return l});e.replaceChildren(n,...s),this.chosen(this.run)}};function AE(i){let[t]=i.eigenvalue,e=i.frequency>0?[`${i.frequency.toPrecision(4)} Hz`]:[`${t.toPrecision(4)} 1/s`];return i.frequency>0&&i.damping!==null&&Math.abs(i.damping)>1e-7&&e.push(`damping ${i.damping.toPrecision(3)}`),i.constant!==null&&e.push(`${i.constant>0?"falls":"grows"} in ${Math.abs(i.constant).toPrecision(3)} s`),e.join(", ")}var CE=1e-12,RE=12;function PE(i){return i.group==="parameter"||i.kind!=="Real"}function B0({minimum:i,maximum:t,display:e},n){let s=r=>Math.abs(n-r)<=CE*(Math.abs(r)+Math.abs(e.shift/e.scale));return[i,t].find(r=>r!==null&&s(r))??n}function IE(i,t){let{minimum:e,maximum:n}=i;if(Number.isNaN(t))return"this is no number";let s=wh(i,t);return Number.isFinite(t)?i.kind!=="Real"&&!Number.isSafeInteger(t)?`${s} is no whole number below 2^53`:e!==null&&t<e?`${s} is below min = ${wh(i,e)}`:n!==null&&t>n?`${s} is above max = ${wh(i,n)}`:"":`${s} is not finite`}function cf(i,t,e){let n=IE(i,t),s=Number.isFinite(t)&&(n===""||!PE(i));return n===""?{taken:s,words:n}:{taken:s,words:s?`${n}; the run takes it`:`${n}; the value stays ${wh(i,e)}`}}function wh({display:i},t){return`${Xi(t*i.scale+i.shift,RE)} ${i.unit}`.trim()}var LE=[["start","Start values"],["parameter","Parameters"],["input","Inputs"]],hf=1e3;function DE(i,t){let{minimum:e,maximum:n,display:s}=i,r=Math.min(Math.max(i.value,e??-1/0),n??1/0),[o,a]=r===0?[-1,1]:[r/Math.sqrt(10),r*Math.sqrt(10)];if(i.angle)[o,a]=[Math.min(-Math.PI,r),Math.max(Math.PI,r)];else if(i.group!=="parameter"){let l=zr((Math.max(2*Math.abs(r),t)||1)*s.scale)/s.scale;[o,a]=[-l,l]}return o>a&&([o,a]=[a,o]),[e??o,n??a]}function uf(i,t){return Xi(t*i.display.scale+i.display.shift,4)}function NE(i){return i.split(/(?<=[._])|(?=\[)/).flatMap(t=>[t,document.createElement("wbr")])}var Eh=class{constructor(t,e,n,s){this.head=t;this.motion=e;this.place=n;this.changed=s;this.values=new Map([...t.parameters,...t.inputs].map(o=>[o,o.value]));for(let[o,a]of LE){let l=[...this.values.keys()].filter(d=>d.group===o);if(l.length===0)continue;let c=document.createElement("details");c.open=l.length<=24;let h=document.createElement("summary");h.textContent=a,c.append(h,...l.map(d=>this.row(d))),n.append(c)}let r=document.createElement("button");r.textContent="Reset all",r.onclick=()=>{for(let o of this.values.keys())this.values.set(o,o.value);n.querySelectorAll("input").forEach(o=>o.dispatchEvent(new Event("reread"))),s()},n.append(r)}head;motion;place;changed;values;get parameters(){return Float64Array.from(this.head.parameters,t=>this.values.get(t)??t.value)}get inputs(){return Float64Array.from(this.head.inputs,t=>this.values.get(t)??t.value)}take(t){this.head.parameters.forEach((e,n)=>this.values.set(e,t[n])),this.place.querySelectorAll("input").forEach(e=>e.dispatchEvent(new Event("reread")))}largest(t){let e=this.head.columns.find(o=>o.name===t),n=this.head.columns.map((o,a)=>e!==void 0&&o.kind===e.kind&&o.unit===e.unit?this.motion.largest(a):0),[s,r]=[e===void 0?0:n[this.head.columns.indexOf(e)],Math.max(...n)];return s>1e-9*r?s:r}row(t){let e=t.group==="start"?t.name.replace(/\.start$/,""):t.name,[n,s]=DE(t,t.group==="start"?this.largest(e):0),r=document.createElement("label");r.title=t.doc??"";let o=document.createElement("span");o.append(...NE(e));let a=document.createElement("input"),l=t.kind!=="Real";Object.assign(a,{type:"range",min:"0",max:`${hf}`,step:l?"any":"1"}),a.setAttribute("aria-label",t.name);let c=document.createElement("input");Object.assign(c,{type:"number",step:"any"}),c.setAttribute("aria-label",`${t.name} in ${t.display.unit||"SI units"}`);let h=document.createElement("span");h.className="unit",h.textContent=t.display.unit;let d=document.createElement("span");d.className="fault",d.setAttribute("aria-live","polite");let u=m=>{d.textContent=m,d.hidden=m==="",c.setAttribute("aria-invalid",`${m!==""}`)},p=()=>this.values.get(t)??t.value,g=()=>{let m=p();a.value=`${hf*(m-n)/(s-n||1)}`,c.value=uf(t,m),u(cf(t,m,m).words)},S=m=>{let f=B0(t,m),{taken:M,words:R}=cf(t,f,p());M&&(this.values.set(t,f),this.changed()),g(),u(R)};return a.oninput=()=>{let m=n+(s-n)*Number(a.value)/hf;S(l?Math.round(m):m)},c.onchange=()=>S((c.valueAsNumber-t.display.shift)/t.display.scale),a.addEventListener("reread",g),r.ondblclick=()=>S(t.value),g(),r.append(o,a,c,h,d),r}};var Th=class{lines;pinned=[];constructor(t,e,n,s){this.lines=t.source.split(`
`).map((r,o)=>{let a=document.createElement("div");a.className="line",a.dataset.number=`${o+1}`,a.textContent=r===""?"\u200B":r;let l={first:[o+1,1],last:[o+2,1]};return a.onpointerenter=()=>n(l),a.onpointerleave=()=>n(null),a.onclick=()=>s(l),a}),e.append(...this.lines)}pin(t){this.pinned=t,this.mark(t)}mark(t){this.lines.forEach((e,n)=>{e.classList.toggle("marked",[...t,...this.pinned].some(s=>n+1>=s.first[0]&&n+1<=s.last[0]))}),t.length>0&&this.lines[t[0].first[0]-1]?.scrollIntoView({block:"nearest"})}};var z0={type:"change"},ff={type:"start"},G0={type:"end"},Ah=new Bs,k0=new oi,UE=Math.cos(70*fh.DEG2RAD),Sn=new O,Jn=2*Math.PI,Ie={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},df=1e-6,Ch=class extends Ta{constructor(t,e=null){super(t,e),this.state=Ie.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ws.ROTATE,MIDDLE:Ws.DOLLY,RIGHT:Ws.PAN},this.touches={ONE:Xs.ROTATE,TWO:Xs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new ai,this._lastTargetPosition=new O,this._quat=new ai().setFromUnitVectors(t.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new vo,this._sphericalDelta=new vo,this._scale=1,this._panOffset=new O,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new O,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=OE.bind(this),this._onPointerDown=FE.bind(this),this._onPointerUp=BE.bind(this),this._onContextMenu=XE.bind(this),this._onMouseWheel=GE.bind(this),this._onKeyDown=VE.bind(this),this._onTouchStart=HE.bind(this),this._onTouchMove=WE.bind(this),this._onMouseDown=zE.bind(this),this._onMouseMove=kE.bind(this),this._interceptControlDown=qE.bind(this),this._interceptControlUp=YE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ie.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(z0),this.update(),this.state=Ie.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Ie.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Jn:n>Math.PI&&(n-=Jn),s<-Math.PI?s+=Jn:s>Math.PI&&(s-=Jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new O(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ah.origin.copy(this.object.position),Ah.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ah.direction))<UE?this.object.lookAt(this.target):(k0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ah.intersectPlane(k0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>df||8*(1-this._lastQuaternion.dot(this.object.quaternion))>df||this._lastTargetPosition.distanceToSquared(this.target)>df?(this.dispatchEvent(z0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Jn/60*this.autoRotateSpeed*t:Jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function FE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function OE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function BE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(G0),this.state=Ie.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function zE(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ws.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ie.DOLLY;break;case Ws.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ie.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ie.ROTATE}break;case Ws.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ie.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ie.PAN}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(ff)}function kE(i){switch(this.state){case Ie.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ie.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ie.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function GE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ie.NONE||(i.preventDefault(),this.dispatchEvent(ff),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(G0))}function VE(i){this.enabled!==!1&&this._handleKeyDown(i)}function HE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Xs.ROTATE:if(this.enableRotate===!1){this.state=Ie.NONE;break}this._handleTouchStartRotate(i),this.state=Ie.TOUCH_ROTATE;break;case Xs.PAN:if(this.enablePan===!1){this.state=Ie.NONE;break}this._handleTouchStartPan(i),this.state=Ie.TOUCH_PAN;break;default:this.state=Ie.NONE}break;case 2:switch(this.touches.TWO){case Xs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ie.TOUCH_DOLLY_PAN;break;case Xs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ie.TOUCH_DOLLY_ROTATE;break;default:this.state=Ie.NONE}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(ff)}function WE(i){switch(this._trackPointer(i),this.state){case Ie.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ie.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ie.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ie.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ie.NONE}}function XE(i){this.enabled!==!1&&i.preventDefault()}function qE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function YE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Rh(i,t){return new an(t,new Li({color:i}))}function V0(i,t,e,n,s,r){let o=.16*t.length,a=new O().setFromMatrixColumn(n,0),l=new O().setFromMatrixColumn(n,1),c=new Pn;c.quaternion.setFromRotationMatrix(n);let h=e.getCenter(new O),d=Math.min(l.dot(e.min),l.dot(e.max))-l.dot(h);c.position.copy(h).addScaledVector(l,d-1.7*o),c.position.addScaledVector(a,(s-(r-1)/2)*2.6*o);let u=rf(i.name,.4*o,"#64748b");u.position.set(0,-1.3*o,0),c.add(u);let p=f=>f.numbers[f.first+i.numbers.value];if(i.kind==="dial"){let f=Rh(2450411,new $n(.12*o,o,.12*o));return f.geometry.translate(0,.5*o,0),c.add(Rh(9741240,new hr(o,.05*o,12,64)),f),{object:c,shape:i,update:M=>{f.rotation.set(0,0,p(M))}}}let g=Rh(2450411,new $n(.5*o,.5*o,.5*o));c.add(Rh(9741240,new $n(2.2*o,.06*o,.06*o)),g);let S=null,m=1;return{object:c,shape:i,update:f=>{g.position.x=.85*o*p(f)/m},follow(f){f!==S&&(S=f,m=Math.max(f.largest(t.first+i.numbers.value),1e-12))}}}var pf=class{constructor(){this.id=0,this.object=null,this.z=0,this.renderOrder=0}},Xa=class{constructor(){this.id=0,this.v1=new ws,this.v2=new ws,this.v3=new ws,this.normalModel=new O,this.vertexNormalsModel=[new O,new O,new O],this.vertexNormalsLength=0,this.color=new ee,this.material=null,this.uvs=[new Zt,new Zt,new Zt],this.z=0,this.renderOrder=0}},ws=class{constructor(){this.position=new O,this.positionWorld=new O,this.positionScreen=new Ce,this.visible=!0}copy(t){this.positionWorld.copy(t.positionWorld),this.positionScreen.copy(t.positionScreen)}},qa=class{constructor(){this.id=0,this.v1=new ws,this.v2=new ws,this.vertexColors=[new ee,new ee],this.material=null,this.z=0,this.renderOrder=0}},Ya=class{constructor(){this.id=0,this.object=null,this.x=0,this.y=0,this.z=0,this.rotation=0,this.scale=new Zt,this.material=null,this.renderOrder=0}},Ph=class{constructor(){let t,e,n=0,s,r,o=0,a,l,c=0,h,d,u=0,p,g,S=0,m,f=[],M=[],R={objects:[],lights:[],elements:[]},v=new O,C=new Ce,A=new ci(new O(-1,-1,-1),new O(1,1,1)),_=new ci,E=new Array(3),B=new me,N=new me,D=new me,z=new Zi,W=[],L=[],V=[],q=[],H=[],ct=[],Y=new Ce,j=new Ce,it=new Ce,pt=[],ht=[null,null,null],tt=[{sign:1},{sign:-1}];function gt(){let K=[],dt=[],xt=[],bt=null,_t=new oe;function Yt(y){bt=y,_t.getNormalMatrix(bt.matrixWorld),K.length=0,dt.length=0,xt.length=0}function P(y){let k=y.position,st=y.positionWorld,Q=y.positionScreen;st.copy(k).applyMatrix4(m),Q.copy(st).applyMatrix4(N);let mt=1/Q.w;Q.x*=mt,Q.y*=mt,Q.z*=mt,y.visible=Q.x>=-1&&Q.x<=1&&Q.y>=-1&&Q.y<=1&&Q.z>=-1&&Q.z<=1}function ut(y,k,st){s=Jt(),s.position.set(y,k,st),P(s)}function kt(y,k,st){K.push(y,k,st)}function Ut(y,k,st){dt.push(y,k,st)}function yt(y,k){xt.push(y,k)}function Xt(y,k,st){return y.visible===!0||k.visible===!0||st.visible===!0?!0:(E[0]=y.positionScreen,E[1]=k.positionScreen,E[2]=st.positionScreen,A.intersectsBox(_.setFromPoints(E)))}function Et(y,k,st){return(st.positionScreen.x-y.positionScreen.x)*(k.positionScreen.y-y.positionScreen.y)-(st.positionScreen.y-y.positionScreen.y)*(k.positionScreen.x-y.positionScreen.x)<0}function Gt(y,k){let st=L[y],Q=L[k];st.positionScreen.copy(st.position).applyMatrix4(D),Q.positionScreen.copy(Q.position).applyMatrix4(D),We(st.positionScreen,Q.positionScreen)===!0&&(st.positionScreen.multiplyScalar(1/st.positionScreen.w),Q.positionScreen.multiplyScalar(1/Q.positionScreen.w),h=fe(),h.id=bt.id,h.v1.copy(st),h.v2.copy(Q),h.z=Math.max(st.positionScreen.z,Q.positionScreen.z),h.renderOrder=bt.renderOrder,h.material=bt.material,bt.material.vertexColors&&(h.vertexColors[0].fromArray(dt,y*3),h.vertexColors[1].fromArray(dt,k*3)),R.elements.push(h))}function T(y,k,st,Q){let mt=L[y],vt=L[k],et=L[st],rt=mt.positionScreen.w,St=vt.positionScreen.w,F=et.positionScreen.w,at=rt*(mt.positionScreen.z+1),ot=St*(vt.positionScreen.z+1),Pt=F*(et.positionScreen.z+1),Tt=rt*(1-mt.positionScreen.z),Rt=St*(1-vt.positionScreen.z),Qt=F*(1-et.positionScreen.z);if(at<0&&ot<0&&Pt<0||Tt<0&&Rt<0&&Qt<0)return;if(at>=0&&ot>=0&&Pt>=0&&Tt>=0&&Rt>=0&&Qt>=0){if(Xt(mt,vt,et)===!1)return;if(Q.side===Yn||Et(mt,vt,et)===!0){a=de(),a.id=bt.id,a.v1.copy(mt),a.v2.copy(vt),a.v3.copy(et),a.z=(mt.positionScreen.z+vt.positionScreen.z+et.positionScreen.z)/3,a.renderOrder=bt.renderOrder,v.subVectors(et.position,vt.position),C.subVectors(mt.position,vt.position),v.cross(C),a.normalModel.copy(v),a.normalModel.applyMatrix3(_t).normalize();for(let lt=0;lt<3;lt++){let Ot=a.vertexNormalsModel[lt];Ot.fromArray(K,arguments[lt]*3),Ot.applyMatrix3(_t).normalize(),a.uvs[lt].fromArray(xt,arguments[lt]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(dt,y*3),R.elements.push(a)}return}Y.set(mt.positionScreen.x*rt,mt.positionScreen.y*rt,mt.positionScreen.z*rt,rt),j.set(vt.positionScreen.x*St,vt.positionScreen.y*St,vt.positionScreen.z*St,St),it.set(et.positionScreen.x*F,et.positionScreen.y*F,et.positionScreen.z*F,F),ht[0]=Y,ht[1]=j,ht[2]=it;let ie=Le(ht);if(!(ie<3)){for(let lt=0;lt<ie;lt++){let Ot=f[lt],te=pt[lt];te||(te=new ws,pt[lt]=te);let Ct=1/Ot.w;te.positionScreen.set(Ot.x*Ct,Ot.y*Ct,Ot.z*Ct,1),te.positionWorld.copy(mt.positionWorld),te.visible=!0}for(let lt=1;lt<ie-1;lt++){let Ot=pt[0],te=pt[lt],Ct=pt[lt+1];if(Q.side===Yn||Et(Ot,te,Ct)===!0){a=de(),a.id=bt.id,a.v1.copy(Ot),a.v2.copy(te),a.v3.copy(Ct),a.z=(Ot.positionScreen.z+te.positionScreen.z+Ct.positionScreen.z)/3,a.renderOrder=bt.renderOrder,v.subVectors(et.position,vt.position),C.subVectors(mt.position,vt.position),v.cross(C),a.normalModel.copy(v),a.normalModel.applyMatrix3(_t).normalize();for(let ae=0;ae<3;ae++){let ke=a.vertexNormalsModel[ae];ke.fromArray(K,arguments[ae]*3),ke.applyMatrix3(_t).normalize(),a.uvs[ae].fromArray(xt,arguments[ae]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(dt,y*3),R.elements.push(a)}}}}return{setObject:Yt,projectVertex:P,checkTriangleVisibility:Xt,checkBackfaceCulling:Et,pushVertex:ut,pushNormal:kt,pushColor:Ut,pushUv:yt,pushLine:Gt,pushTriangle:T}}let Mt=new gt;function Lt(K){if(K.visible===!1)return;if(K.isLight)R.lights.push(K);else if(K.isMesh||K.isLine||K.isPoints){if(K.material.visible===!1||K.frustumCulled===!0&&z.intersectsObject(K)===!1)return;At(K)}else if(K.isSprite){if(K.material.visible===!1||K.frustumCulled===!0&&z.intersectsSprite(K)===!1)return;At(K)}let dt=K.children;for(let xt=0,bt=dt.length;xt<bt;xt++)Lt(dt[xt])}function At(K){t=he(),t.id=K.id,t.object=K,v.setFromMatrixPosition(K.matrixWorld),v.applyMatrix4(N),t.z=v.z,t.renderOrder=K.renderOrder,R.objects.push(t)}this.projectScene=function(K,dt,xt,bt){l=0,d=0,g=0,R.elements.length=0,K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),dt.parent===null&&dt.matrixWorldAutoUpdate===!0&&dt.updateMatrixWorld(),B.copy(dt.matrixWorldInverse),N.multiplyMatrices(dt.projectionMatrix,B),z.setFromProjectionMatrix(N),e=0,R.objects.length=0,R.lights.length=0,Lt(K),xt===!0&&R.objects.sort(Ue);let _t=R.objects;for(let Yt=0,P=_t.length;Yt<P;Yt++){let ut=_t[Yt].object,kt=ut.geometry;if(Mt.setObject(ut),m=ut.matrixWorld,r=0,ut.isMesh){let Ut=ut.material,yt=Array.isArray(Ut),Xt=kt.attributes,Et=kt.groups;if(Xt.position===void 0)continue;let Gt=Xt.position.array;for(let T=0,y=Gt.length;T<y;T+=3){let k=Gt[T],st=Gt[T+1],Q=Gt[T+2],mt=kt.morphAttributes.position;if(mt!==void 0){let vt=kt.morphTargetsRelative,et=ut.morphTargetInfluences;for(let rt=0,St=mt.length;rt<St;rt++){let F=et[rt];if(F===0)continue;let at=mt[rt];vt?(k+=at.getX(T/3)*F,st+=at.getY(T/3)*F,Q+=at.getZ(T/3)*F):(k+=(at.getX(T/3)-Gt[T])*F,st+=(at.getY(T/3)-Gt[T+1])*F,Q+=(at.getZ(T/3)-Gt[T+2])*F)}}Mt.pushVertex(k,st,Q)}if(Xt.normal!==void 0){let T=Xt.normal.array;for(let y=0,k=T.length;y<k;y+=3)Mt.pushNormal(T[y],T[y+1],T[y+2])}if(Xt.color!==void 0){let T=Xt.color.array;for(let y=0,k=T.length;y<k;y+=3)Mt.pushColor(T[y],T[y+1],T[y+2])}if(Xt.uv!==void 0){let T=Xt.uv.array;for(let y=0,k=T.length;y<k;y+=2)Mt.pushUv(T[y],T[y+1])}if(kt.index!==null){let T=kt.index.array;if(Et.length>0)for(let y=0;y<Et.length;y++){let k=Et[y];if(Ut=yt===!0?ut.material[k.materialIndex]:ut.material,Ut!==void 0)for(let st=k.start,Q=k.start+k.count;st<Q;st+=3)Mt.pushTriangle(T[st],T[st+1],T[st+2],Ut)}else for(let y=0,k=T.length;y<k;y+=3)Mt.pushTriangle(T[y],T[y+1],T[y+2],Ut)}else if(Et.length>0)for(let T=0;T<Et.length;T++){let y=Et[T];if(Ut=yt===!0?ut.material[y.materialIndex]:ut.material,Ut!==void 0)for(let k=y.start,st=y.start+y.count;k<st;k+=3)Mt.pushTriangle(k,k+1,k+2,Ut)}else for(let T=0,y=Gt.length/3;T<y;T+=3)Mt.pushTriangle(T,T+1,T+2,Ut)}else if(ut.isLine){D.multiplyMatrices(N,m);let Ut=kt.attributes;if(Ut.position!==void 0){let yt=Ut.position.array;for(let Xt=0,Et=yt.length;Xt<Et;Xt+=3)Mt.pushVertex(yt[Xt],yt[Xt+1],yt[Xt+2]);if(Ut.color!==void 0){let Xt=Ut.color.array;for(let Et=0,Gt=Xt.length;Et<Gt;Et+=3)Mt.pushColor(Xt[Et],Xt[Et+1],Xt[Et+2])}if(kt.index!==null){let Xt=kt.index.array;for(let Et=0,Gt=Xt.length;Et<Gt;Et+=2)Mt.pushLine(Xt[Et],Xt[Et+1])}else{let Xt=ut.isLineSegments?2:1;for(let Et=0,Gt=yt.length/3-1;Et<Gt;Et+=Xt)Mt.pushLine(Et,Et+1)}}}else if(ut.isPoints){D.multiplyMatrices(N,m);let Ut=kt.attributes;if(Ut.position!==void 0){let yt=Ut.position.array;for(let Xt=0,Et=yt.length;Xt<Et;Xt+=3)C.set(yt[Xt],yt[Xt+1],yt[Xt+2],1),C.applyMatrix4(D),jt(C,ut,dt)}}else ut.isSprite&&(ut.modelViewMatrix.multiplyMatrices(dt.matrixWorldInverse,ut.matrixWorld),C.set(m.elements[12],m.elements[13],m.elements[14],1),C.applyMatrix4(N),jt(C,ut,dt))}return bt===!0&&R.elements.sort(Ue),R};function jt(K,dt,xt){let bt=1/K.w;K.z*=bt,K.z>=-1&&K.z<=1&&(p=re(),p.id=dt.id,p.x=K.x*bt,p.y=K.y*bt,p.z=K.z,p.renderOrder=dt.renderOrder,p.object=dt,p.rotation=dt.rotation,p.scale.x=dt.scale.x*Math.abs(p.x-(K.x+xt.projectionMatrix.elements[0])/(K.w+xt.projectionMatrix.elements[12])),p.scale.y=dt.scale.y*Math.abs(p.y-(K.y+xt.projectionMatrix.elements[5])/(K.w+xt.projectionMatrix.elements[13])),p.material=dt.material,R.elements.push(p))}function he(){if(e===n){let K=new pf;return W.push(K),n++,e++,K}return W[e++]}function Jt(){if(r===o){let K=new ws;return L.push(K),o++,r++,K}return L[r++]}function de(){if(l===c){let K=new Xa;return V.push(K),c++,l++,K}return V[l++]}function fe(){if(d===u){let K=new qa;return q.push(K),u++,d++,K}return q[d++]}function re(){if(g===S){let K=new Ya;return H.push(K),S++,g++,K}return H[g++]}function Ue(K,dt){return K.renderOrder!==dt.renderOrder?K.renderOrder-dt.renderOrder:K.z!==dt.z?dt.z-K.z:K.id!==dt.id?K.id-dt.id:0}function Le(K){f[0]=K[0],f[1]=K[1],f[2]=K[2];let dt=3,xt=0;for(let bt=0;bt<tt.length;bt++){let _t=tt[bt];if(xt=0,dt===0)break;for(let P=0;P<dt;P++){let ut=f[P],kt=f[(P+1)%dt],Ut=_t.sign*ut.z+ut.w,yt=_t.sign*kt.z+kt.w,Xt=Ut>=0,Et=yt>=0;if(Xt&&Et)M[xt++]=ut;else if(Xt&&!Et){M[xt++]=ut;let Gt=Ut/(Ut-yt),T=ct[xt];T||(T=new Ce,ct[xt]=T),T.lerpVectors(ut,kt,Gt),M[xt++]=T}else if(!Xt&&Et){let Gt=Ut/(Ut-yt),T=ct[xt];T||(T=new Ce,ct[xt]=T),T.lerpVectors(ut,kt,Gt),M[xt++]=T}}let Yt=f;f=M,M=Yt,dt=xt}return dt}function We(K,dt){let xt=0,bt=1,_t=K.z+K.w,Yt=dt.z+dt.w,P=-K.z+K.w,ut=-dt.z+dt.w;return _t>=0&&Yt>=0&&P>=0&&ut>=0?!0:_t<0&&Yt<0||P<0&&ut<0?!1:(_t<0?xt=Math.max(xt,_t/(_t-Yt)):Yt<0&&(bt=Math.min(bt,_t/(_t-Yt))),P<0?xt=Math.max(xt,P/(P-ut)):ut<0&&(bt=Math.min(bt,P/(P-ut))),bt<xt?!1:(K.lerp(dt,xt),dt.lerp(K,1-bt),!0))}}};var Ih=class{constructor(){let t,e,n,s,r,o,a,l,c,h,d,u=0,p=0,g=0,S=null,m=1,f,M,R=this,v=new So,C=new So,A=new ee,_=new ee,E=new ee,B=new ee,N=new ee,D=new ee,z=new O,W=new O,L=new O,V=new O,q=new oe,H=new me,ct=new me,Y=[],j=[],it=[],pt=new Ph,ht=document.createElementNS("http://www.w3.org/2000/svg","svg");this.domElement=ht,this.autoClear=!0,this.sortObjects=!0,this.sortElements=!0,this.overdraw=.5,this.outputColorSpace=Vn,this.info={render:{vertices:0,faces:0}},this.setQuality=function(K){switch(K){case"high":m=1;break;case"low":m=0;break}},this.setClearColor=function(K){D.set(K)},this.setPixelRatio=function(){},this.setSize=function(K,dt){s=K,r=dt,o=s/2,a=r/2,ht.setAttribute("viewBox",-o+" "+-a+" "+s+" "+r),ht.setAttribute("width",s),ht.setAttribute("height",r),v.min.set(-o,-a),v.max.set(o,a)},this.getSize=function(){return{width:s,height:r}},this.setPrecision=function(K){S=K};function tt(){for(u=0;ht.childNodes.length>0;)ht.removeChild(ht.childNodes[0])}function gt(K){return S!==null?K.toFixed(S):K}function Mt(K,dt){let xt=K.data.renderOrder!==void 0?K.data.renderOrder:0,bt=dt.data.renderOrder!==void 0?dt.data.renderOrder:0;if(xt!==bt)return xt-bt;{let _t=K.data.z!==void 0?K.data.z:0;return(dt.data.z!==void 0?dt.data.z:0)-_t}}this.clear=function(){tt(),ht.style.backgroundColor=D.getStyle(R.outputColorSpace)},this.render=function(K,dt){if(!(dt instanceof ur)){console.error("THREE.SVGRenderer.render: camera is not an instance of Camera.");return}let xt=K.background;xt&&xt.isColor?(tt(),ht.style.backgroundColor=xt.getStyle(R.outputColorSpace)):this.autoClear===!0&&this.clear(),R.info.render.vertices=0,R.info.render.faces=0,H.copy(dt.matrixWorldInverse),ct.multiplyMatrices(dt.projectionMatrix,H),t=pt.projectScene(K,dt,this.sortObjects,this.sortElements),e=t.elements,n=t.lights,q.getNormalMatrix(dt.matrixWorldInverse),Lt(n),g=0;for(let bt=0,_t=e.length;bt<_t;bt++){let Yt=e[bt],P=Yt.material;P===void 0||P.opacity===0||We(g++,"element",Yt,P)}p=0,K.traverseVisible(function(bt){if(bt.isSVGObject){if(z.setFromMatrixPosition(bt.matrixWorld),z.applyMatrix4(ct),z.z<-1||z.z>1)return;let _t=z.x*o,Yt=-z.y*a,P=Le(p++);P.node=bt.node,P.x=_t,P.y=Yt,P.z=z.z,P.renderOrder=bt.renderOrder,We(g++,"svgObject",P,null)}}),it.length=g,this.sortElements&&p>0&&it.sort(Mt),f="",M="";for(let bt=0;bt<g;bt++){let _t=it[bt];if(_t.type==="svgObject"){re();let Yt=_t.data,P=Yt.node;P.setAttribute("transform","translate("+Yt.x+","+Yt.y+")"),ht.appendChild(P)}else{let Yt=_t.data,P=_t.material;C.makeEmpty(),Yt instanceof Ya?(l=Yt,l.x*=o,l.y*=-a,jt(l,Yt,P)):Yt instanceof qa?(l=Yt.v1,c=Yt.v2,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,C.setFromPoints([l.positionScreen,c.positionScreen]),v.intersectsBox(C)===!0&&he(l,c,P)):Yt instanceof Xa&&(l=Yt.v1,c=Yt.v2,h=Yt.v3,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,h.positionScreen.x*=o,h.positionScreen.y*=-a,this.overdraw>0&&(de(l.positionScreen,c.positionScreen,this.overdraw),de(c.positionScreen,h.positionScreen,this.overdraw),de(h.positionScreen,l.positionScreen,this.overdraw)),C.setFromPoints([l.positionScreen,c.positionScreen,h.positionScreen]),v.intersectsBox(C)===!0&&Jt(l,c,h,Yt,P))}}re()};function Lt(K){E.setRGB(0,0,0),B.setRGB(0,0,0),N.setRGB(0,0,0);for(let dt=0,xt=K.length;dt<xt;dt++){let bt=K[dt],_t=bt.color;bt.isAmbientLight?(E.r+=_t.r,E.g+=_t.g,E.b+=_t.b):bt.isDirectionalLight?(B.r+=_t.r,B.g+=_t.g,B.b+=_t.b):bt.isPointLight&&(N.r+=_t.r,N.g+=_t.g,N.b+=_t.b)}}function At(K,dt,xt,bt){for(let _t=0,Yt=K.length;_t<Yt;_t++){let P=K[_t],ut=P.color;if(P.isDirectionalLight){let kt=z.setFromMatrixPosition(P.matrixWorld).sub(W.setFromMatrixPosition(P.target.matrixWorld)).normalize(),Ut=xt.dot(kt);if(Ut<=0)continue;Ut*=P.intensity,bt.r+=ut.r*Ut,bt.g+=ut.g*Ut,bt.b+=ut.b*Ut}else if(P.isPointLight){let kt=z.setFromMatrixPosition(P.matrixWorld),Ut=xt.dot(z.subVectors(kt,dt).normalize());if(Ut<=0||(Ut*=P.distance==0?1:1-Math.min(dt.distanceTo(kt)/P.distance,1),Ut==0))continue;Ut*=P.intensity,bt.r+=ut.r*Ut,bt.g+=ut.g*Ut,bt.b+=ut.b*Ut}}}function jt(K,dt,xt){let bt=dt.scale.x*o,_t=dt.scale.y*a;xt.isPointsMaterial&&(bt*=xt.size,_t*=xt.size);let Yt="M"+gt(K.x-bt*.5)+","+gt(K.y-_t*.5)+"h"+gt(bt)+"v"+gt(_t)+"h"+gt(-bt)+"z",P="";(xt.isSpriteMaterial||xt.isPointsMaterial)&&(P="fill:"+xt.color.getStyle(R.outputColorSpace)+";fill-opacity:"+xt.opacity),fe(P,Yt)}function he(K,dt,xt){let bt="M"+gt(K.positionScreen.x)+","+gt(K.positionScreen.y)+"L"+gt(dt.positionScreen.x)+","+gt(dt.positionScreen.y);if(xt.isLineBasicMaterial){let _t="fill:none;stroke:"+xt.color.getStyle(R.outputColorSpace)+";stroke-opacity:"+xt.opacity+";stroke-width:"+xt.linewidth+";stroke-linecap:"+xt.linecap;xt.isLineDashedMaterial&&(_t=_t+";stroke-dasharray:"+xt.dashSize+","+xt.gapSize),fe(_t,bt)}}function Jt(K,dt,xt,bt,_t){R.info.render.vertices+=3,R.info.render.faces++;let Yt="M"+gt(K.positionScreen.x)+","+gt(K.positionScreen.y)+"L"+gt(dt.positionScreen.x)+","+gt(dt.positionScreen.y)+"L"+gt(xt.positionScreen.x)+","+gt(xt.positionScreen.y)+"z",P="";_t.isMeshBasicMaterial?(A.copy(_t.color),_t.vertexColors&&A.multiply(bt.color)):_t.isMeshLambertMaterial||_t.isMeshPhongMaterial||_t.isMeshStandardMaterial?(_.copy(_t.color),_t.vertexColors&&_.multiply(bt.color),A.copy(E),L.copy(K.positionWorld).add(dt.positionWorld).add(xt.positionWorld).divideScalar(3),At(n,L,bt.normalModel,A),A.multiply(_).add(_t.emissive)):_t.isMeshNormalMaterial&&(V.copy(bt.normalModel).applyMatrix3(q).normalize(),A.setRGB(V.x,V.y,V.z).multiplyScalar(.5).addScalar(.5)),_t.wireframe?P="fill:none;stroke:"+A.getStyle(R.outputColorSpace)+";stroke-opacity:"+_t.opacity+";stroke-width:"+_t.wireframeLinewidth+";stroke-linecap:"+_t.wireframeLinecap+";stroke-linejoin:"+_t.wireframeLinejoin:P="fill:"+A.getStyle(R.outputColorSpace)+";fill-opacity:"+_t.opacity,fe(P,Yt)}function de(K,dt,xt){let bt=dt.x-K.x,_t=dt.y-K.y,Yt=bt*bt+_t*_t;if(Yt===0)return;let P=xt/Math.sqrt(Yt);bt*=P,_t*=P,dt.x+=bt,dt.y+=_t,K.x-=bt,K.y-=_t}function fe(K,dt){M===K?f+=dt:(re(),M=K,f=dt)}function re(){f&&(d=Ue(u++),d.setAttribute("d",f),d.setAttribute("style",M),ht.appendChild(d)),f="",M=""}function Ue(K){let dt=Y[K];return dt===void 0&&(dt=document.createElementNS("http://www.w3.org/2000/svg","path"),m==0&&dt.setAttribute("shape-rendering","crispEdges"),Y[K]=dt),dt}function Le(K){let dt=j[K];return dt===void 0&&(dt={node:null,x:0,y:0,z:0,renderOrder:0},j[K]=dt),dt}function We(K,dt,xt,bt){let _t=it[K];return _t===void 0?(_t={type:dt,data:xt,material:bt},it[K]=_t,_t):(_t.type=dt,_t.data=xt,_t.material=bt,_t)}}};function H0(i,t,e,n){let s=[],r=[];i.traverseVisible(l=>{l instanceof gs&&r.push(l),((l instanceof _s||l instanceof _o)&&(l.geometry.getAttribute("position")?.count??0)===0||l instanceof gs||l instanceof an&&l.geometry.getAttribute("position")===void 0)&&s.push(l)});for(let l of s)l.visible=!1;let o=new Ih;o.setSize(e,n),o.setClearColor(i.background instanceof ee?i.background:new ee("white"),1),o.setPrecision(2),o.render(i,t);for(let l of s)l.visible=!0;let a=o.domElement;a.setAttribute("xmlns","http://www.w3.org/2000/svg");for(let l of r){let c=l.getWorldPosition(new O).project(t),h=document.createElementNS("http://www.w3.org/2000/svg","text");h.textContent=`${l.userData.words}`;let d={x:c.x*e/2,y:-c.y*n/2,"text-anchor":"middle","font-family":"sans-serif","font-size":12,fill:"#64748b"};for(let[u,p]of Object.entries(d))h.setAttribute(u,`${p}`);a.append(h)}return new XMLSerializer().serializeToString(a)}var $E=250,ZE=2e3,JE=4,KE=24,W0=2;function jE(i){let t=i.getExtension("WEBGL_debug_renderer_info"),e=i.getParameter(t?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}var Lh=class{constructor(t){this.redraw=t;let e={alpha:!1,depth:!0,stencil:!1,preserveDrawingBuffer:!0},n=document.createElement("canvas"),s=n.getContext("webgl2",{...e,antialias:!1});s!==null&&jE(s)?(this.software=!0,this.renderer=new Ba({canvas:n,context:s,...e})):(this.software=!1,s?.getExtension("WEBGL_lose_context")?.loseContext(),this.renderer=new Ba({...e,antialias:!0})),this.canvas=this.renderer.domElement,this.fine=!this.software,this.ratio()}redraw;canvas;renderer;software;fine=!0;rest=0;before=0;detail(t){return this.software?Math.min(1,Math.sqrt(KE/Math.max(t,1))):1}size(t,e){this.renderer.setSize(t,e)}draw(t,e){this.software&&this.soften(),this.renderer.render(t,e)}soften(){let t=this.rest<0;this.fine!==t&&(this.fine=t,this.ratio()),clearTimeout(this.rest);let e=performance.now(),n=Math.min(Math.max(JE*(e-this.before),$E),ZE);this.before=e,this.rest=t?0:setTimeout(()=>{this.rest=-1,this.redraw()},n)}ratio(){let t=Math.min(window.devicePixelRatio,W0);this.renderer.setPixelRatio(this.software?this.fine?W0:Math.min(t,1):t)}};var QE=200,X0=new Set(["trace","ground","frame","slider","dial","text"]),tT=new Set(["box","cylinder","cone","disc","sphere","mass","body","circle","mesh"]),q0=13,eT=.05,nT=20,Nh=class{constructor(t,e,n,s){this.head=t;this.place=s;this.motion=e,this.screen=new Lh(()=>this.render()),this.canvas=this.screen.canvas,this.canvas.setAttribute("role","img"),this.canvas.setAttribute("aria-label",`The machine ${t.name}, moving`),s.append(this.canvas),this.box=mf(t,e);let r=Math.max(this.box.getSize(new O).length()/Math.SQRT2,1e-9);this.sizes={...sT(t,e,r,this.box.getCenter(new O)),meshes:n,detail:this.screen.detail(t.scene.shapes.length)},this.camera=t.planar?new Hs:new Hn(35,1,r/100,r*100),this.camera.up.set(...t.up),this.controls=new Ch(this.camera,this.canvas),this.controls.enableRotate=!t.planar,this.controls.addEventListener("change",()=>this.render()),this.controls.addEventListener("start",()=>this.moved=!0),this.scene.add(new ba(16777215,.7),new Sa(16777215,9741240,1.2));let o=new Ma(16777215,2);o.position.set(.6,1,1.2),this.camera.add(o),this.scene.add(this.camera,this.ghosts),this.furnish(),this.surround(),this.grid=this.ground(r),this.scene.add(this.grid);let a=new Pn;t.planar&&(a.position.z=2*r),this.scene.add(a),this.overlay=t.vectors?new Sh(t.vectors,this.sizes,a):null,this.theme(),this.aim(),new ResizeObserver(()=>{(s.clientWidth!==this.canvas.clientWidth||s.clientHeight!==this.canvas.clientHeight)&&this.resize()}).observe(s)}head;place;canvas;screen;scene=new ca;camera;controls;drawn=[];box;sizes;grid;ghosts=new Pn;shown={forces:!0,frames:!1};overlay;moved=!1;posed=!1;onlyGauges=!1;motion;furnish(){let t=this.head.scene.shapes.filter(Dh),e=this.box.clone();for(let n of this.head.scene.shapes){let s=Dh(n)?V0(n,this.sizes,e,this.facing(),t.indexOf(n),t.length):vh[n.kind]?.(n,this.sizes);s!==void 0&&(s.object.traverse(r=>r.userData.shape=n),this.drawn.push(s),this.scene.add(s.object))}this.onlyGauges=t.length>0&&this.head.scene.shapes.every(n=>Dh(n)||X0.has(n.kind)),this.show()}enclose(t){let e=this.drawn.filter(({shape:s})=>tT.has(s.kind)),n=new Float64Array(t.width);for(let s=0;s<q0&&t.count>0;++s){let r=Math.round((t.count-1)*s/(q0-1));t.state(t.at(r,0),n);for(let o of e)o.update({numbers:n,first:this.head.scene.first}),o.object.updateMatrixWorld(!0),o.object.visible&&this.box.expandByObject(o.object)}}follow(t){if(this.motion=t,this.moved||this.onlyGauges)return;let e=this.box.clone().expandByScalar(eT*this.sizes.length),n=mf(this.head,t);e.containsBox(n)||n.union(this.box).getSize(new O).length()>nT*this.sizes.length||(this.box.union(n),this.enclose(t),this.aim())}facing(){let t=new O(...this.head.up);if(this.head.planar)return new me;let e=Math.abs(t.z)>.7?new O(.75,-1,0):new O(.6,0,1);return e.addScaledVector(t,-e.dot(t)).normalize(),new me().makeBasis(new O().crossVectors(t,e),t,e)}show(){for(let{object:t,shape:e}of this.drawn)e.kind==="frame"&&(t.visible=this.shown.frames),(e.kind==="force"||e.kind==="torque")&&(t.userData.hidden=!this.shown.forces)}ground(t){let e=10**Math.floor(Math.log10(t/2)),n=2*Math.ceil(1.5*t/e),s=new Ea(n*e,n),r=this.box.getCenter(new O);this.head.planar?s.rotation.x=Math.PI/2:s.quaternion.setFromUnitVectors(new O(0,1,0),new O(...this.head.up));let o=new O(...this.head.up);if(this.head.planar)s.position.set(Y0(r.x,e),Y0(r.y,e),-.2*t);else{let a=Math.min(o.dot(this.box.min),o.dot(this.box.max));s.position.copy(r).addScaledVector(o,a-o.dot(r)-.02*t)}return s}lookAt(){this.moved=!1,this.surround(),this.aim()}surround(){this.onlyGauges?this.box.makeEmpty():(this.box.copy(mf(this.head,this.motion)),this.enclose(this.motion));for(let{object:t,shape:e}of this.drawn)Dh(e)&&this.box.expandByObject(t)}aim(){let t=this.box.getSize(new O).length()/Math.SQRT2;this.grid.scale.setScalar(Math.max(zr(.8*t/this.sizes.length),1)),this.controls.target.copy(this.box.getCenter(new O)),this.resize(),this.controls.update()}fit(t){let e=this.box.getCenter(new O),{length:n}=this.sizes;if(this.camera instanceof Hs){let h=this.box.getSize(new O),d=.12*Math.max(h.x,h.y,.2*n),u=Math.max(h.y/2+d,(h.x/2+d)/t);if(Object.assign(this.camera,{top:u,bottom:-u,right:u*t,left:-u*t}),this.moved)return;Object.assign(this.camera,{near:.1*n,far:30*n,zoom:1}),this.camera.position.copy(e).add(new O(0,0,10*n));return}if(this.camera.aspect=t,this.moved)return;let s=this.facing(),r=new O(0,.38,.92).transformDirection(s),o=new O().setFromMatrixColumn(s,0),a=new O().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360)/1.12,c=0;for(let h=0;h<8;++h){let d=new O(...[0,1,2].map(p=>(h>>p&1?this.box.max:this.box.min).getComponent(p)));d.sub(e);let u=Math.max(Math.abs(d.dot(o))/t,Math.abs(d.dot(a)));c=Math.max(c,d.dot(r)+u/l)}this.camera.position.copy(e).addScaledVector(r,Math.max(c,.5*n))}resize(){let{clientWidth:t,clientHeight:e}=this.place;t===0||e===0||(this.screen.size(t,e),this.fit(t/e),this.camera.updateProjectionMatrix(),this.controls.update(),this.render())}theme(){let t=getComputedStyle(document.documentElement);this.scene.background=new ee(t.getPropertyValue("--stage").trim());let e=new ee(t.getPropertyValue("--grid").trim());for(let n of[this.grid.material].flat())n.vertexColors=!1,n.color=e,n.needsUpdate=!0;this.render()}pose(t,e,n){this.posed=!0;let s={numbers:e,first:this.head.scene.first},r=t.rowAt(n);for(let o of this.drawn)o.follow?.(t,r),o.update(s),o.object.userData.hidden&&(o.object.visible=!1),o.object.updateMatrixWorld(!0);this.overlay?.pose(n),this.render()}postures(t,e){this.ghosts.clear();let n=new Float64Array(t.width);for(let s of e){t.state(s,n);for(let r of this.drawn){if(X0.has(r.shape.kind)||(r.update({numbers:n,first:this.head.scene.first}),!r.object.visible||r.object.userData.hidden))continue;let o=r.object.clone();o.traverse(a=>{if(!(a instanceof an))return;let l=a.material.clone();Object.assign(l,{transparent:!0,opacity:.22,depthWrite:!1}),a.material=l,a.userData.bent&&(a.geometry=a.geometry.clone())}),this.ghosts.add(o)}}this.ghosts.updateMatrixWorld(!0)}sketch(){return H0(this.scene,this.camera,this.place.clientWidth,this.place.clientHeight)}render(){this.posed&&this.screen.draw(this.scene,this.camera)}shapeAt(t,e){let n=this.canvas.getBoundingClientRect(),s=new Zt((t-n.left)/n.width*2-1,1-(e-n.top)/n.height*2),r=new wa;r.setFromCamera(s,this.camera);let o=(this.overlay?.drawn??[]).filter(l=>l.object.visible);return r.intersectObjects([...this.drawn,...o].map(l=>l.object)).find(l=>l.object.visible)?.object.userData.shape??null}value(t,e){if(this.overlay?.drawn.some(s=>s.shape===t))return this.overlay.value(t);if(t.kind!=="force"&&t.kind!=="torque")return"";let n=Ee(t,"vector",{numbers:e,first:this.head.scene.first}).length();return`${Wa(n)} ${Co(t)}`}highlight(t){for(let e of[...this.drawn,...this.overlay?.drawn??[]])e.object.traverse(n=>{n instanceof an&&n.material instanceof Li&&n.material.emissive.setHex(t.includes(e.shape)?8016384:0)});this.render()}};function Dh(i){return i.kind==="slider"||i.kind==="dial"}function Y0(i,t){return Math.round(i/t)*t}function iT(i,t,e){let n=(r,o=0)=>r in t.numbers?e.at(0,i.scene.first+t.numbers[r]+o):0;if(e.count===0)return 0;if(t.kind!=="body")return Math.max(n("radius"),.5*n("length"),.5*n("height"));let s=2.5*(n("inertia")+n("inertia",1)+n("inertia",2))/n("mass");return s>0&&Number.isFinite(s)?.6*Math.sqrt(s):0}function mf(i,t){let e=new ci,n=new O,s=Math.max(1,Math.floor(t.count/QE));for(let o of i.scene.shapes)if(o.kind!=="frame")for(let a of["at","to"]){if(!(a in o.numbers))continue;let l=i.scene.first+o.numbers[a],c=iT(i,o,t);for(let h=0;h<t.count;h+=s)n.set(t.at(h,l),t.at(h,l+1),t.at(h,l+2)),Number.isFinite(n.x+n.y+n.z)&&e.expandByPoint(n.clone().addScalar(c)).expandByPoint(n.clone().addScalar(-c))}return e.isEmpty()&&e.set(new O(0,0,0),new O(0,0,0)),e.getSize(n).length()===0&&e.expandByScalar(.5),e}function sT(i,t,e,n){let s=(o,a,l)=>{let c=0;for(let h of i.scene.shapes){if(h.kind!==o||!(a in h.numbers))continue;let d=i.scene.first+h.numbers[a];for(let u=0;u<t.count;++u){let p=0;for(let g=0;g<l;++g)p+=t.at(u,d+g)**2;Number.isFinite(p)&&(c=Math.max(c,Math.sqrt(p)))}}return c},r=o=>o>0?.3*e/o:0;return{length:e,mass:s("mass","mass",1),force:r(s("force","vector",3)),torque:r(s("torque","vector",3)),planar:i.planar,first:i.scene.first,center:n}}function $0(i){let t=[...document.querySelectorAll("[role=tab]")],e=n=>{for(let s of t)s.ariaSelected=`${s===n}`,s.tabIndex=s===n?0:-1,document.getElementById(s.getAttribute("aria-controls")??"")?.toggleAttribute("hidden",s!==n);i()};t.forEach((n,s)=>{n.onclick=()=>e(n),n.onkeydown=r=>{let o=r.key==="ArrowRight"?1:r.key==="ArrowLeft"?-1:0;if(o===0)return;r.stopPropagation();let a=t[(s+o+t.length)%t.length];e(a),a.focus()}}),e(t[0])}var Uh=class{terms;pinned=null;constructor(t,e,n,s){this.terms=[...e.querySelectorAll("[data-from]")].map(r=>{let a=(r.getAttribute("data-from")??"").split(" ").filter(l=>l!=="").map(l=>t.sources[Number(l)]).filter(l=>l!==null);return{element:r,spans:a}});for(let{element:r,spans:o}of this.terms)r.addEventListener("pointerenter",()=>{this.mark(null),r.classList.add("marked"),n(o)}),r.addEventListener("pointerleave",()=>{this.mark(null),n([])}),r.addEventListener("click",()=>s(o))}first(t){return this.terms.find(({spans:e})=>e.some(n=>Fh(n,t)))?.element??null}pin(t){this.pinned=t,this.mark(null)}mark(t){let e=[t,this.pinned].filter(n=>n!==null);for(let{element:n,spans:s}of this.terms)n.classList.toggle("marked",s.some(r=>e.some(o=>Fh(r,o))))}};function Fh(i,t){return Z0(i.first,t.last)&&Z0(t.first,i.last)}function Z0(i,t){return i[0]<t[0]||i[0]===t[0]&&i[1]<t[1]}function gf(i){return(t,e,n)=>{let s=document.createElement("button");return s.textContent=t,s.title=e,s.onclick=n,i.append(s),s}}function J0(i,t){let e=document.createElement("details");e.className="menu";let n=document.createElement("summary");n.textContent=t;let s=document.createElement("div");return s.onclick=()=>e.open=!1,e.append(n,s),i.append(e),document.addEventListener("pointerdown",r=>{r.target instanceof Node&&e.contains(r.target)||(e.open=!1)}),s}var K0=601,j0=5,Oh=72,rT=480,oT=500,Q0="Keys: space play and pause, arrows step, Home and End, + and - speed, g ghosts, v velocities, f the whole machine";function Ke(i){let t=document.getElementById(i);if(t===null)throw new Error(`the page has no #${i}`);return t}var _f=class{constructor(t,e,n){this.head=t;this.motions=e;this.stage=n;let[s]=e;this.motion=s,this.numbers=new Float64Array(s.width),this.player=new Mh(t,Ke("player"),o=>this.pose(o)),this.sliders=new Eh(t,Au(e),Ke("sliders"),()=>this.again()),this.influence=new xl(t,Ke("sliders")),this.curves=new _l(t,s,Ke("curves"),o=>this.player.go(o)),this.source=new Th(t,Ke("source"),o=>this.follow(o),o=>this.toTerms(o)),this.terms=new Uh(t,Ke("derivation"),o=>this.mark(o),o=>this.toSource(o)),this.cells=this.values();let r=Ke("units");r.onchange=()=>Ke("derivation").classList.toggle("units",r.checked),$0(()=>{this.tell(),this.source.pin([]),this.terms.pin(null)}),this.tools(),this.keys(),this.pointer(),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.stage.theme()),this.say(t.said),this.pose(t.start),this.tell(),window.addEventListener("beforeprint",()=>this.tell()),t.modes!==void 0&&(Ke("sliders-tab").textContent="Modes"),new bh(t,Ke("sliders"),o=>this.choose(o)),e.length>1&&t.modes===void 0&&this.curves.behind(e)}head;motions;stage;motion;numbers;player;sliders;influence;curves;source;terms;cells;live=null;ghosts=!1;arrows=null;endFilm=null;ghostly=null;speedy=null;async begin(){this.live=await sr.begin(this.head,K0,t=>this.arrived(t));for(let t of Ke("sliders").querySelectorAll(":scope > :not(#runs)"))t.toggleAttribute("inert",this.live===null),t.hidden=this.head.live===!1;this.live===null&&this.head.live!==!1&&this.say("This browser shows the recorded motion only: sliders need WebAssembly."),this.live!==null&&this.influence.rest(this.sliders.parameters,this.sliders.inputs),document.documentElement.dataset.ready=this.live===null?"recorded":"live",matchMedia("(prefers-reduced-motion: reduce)").matches||this.player.play()}choose(t){let e=this.head.runs?.[t];e!==void 0&&(this.motion=this.motions[t],this.player.over(e.start,e.stop,e.pace),this.player.mark(e.events),this.curves.show(this.motion,e.events),e.parameters!==null&&this.sliders.take(e.parameters),this.say(e.said===""?e.label:`${e.label}: ${e.said}`),this.stage.follow(this.motion),this.haunt(),this.pose(this.player.time),e.parameters!==null&&e.said===""&&this.again())}haunt(){let{last:t}=this.motion,e=this.motion.count>0?this.motion.at(0,0):0,n=Array.from({length:j0},(s,r)=>e+(t-e)*r/(j0-1));this.stage.postures(this.motion,this.ghosts?n:[])}pose(t){let e=Math.min(t,this.motion.last);this.motion.state(e,this.numbers),this.stage.pose(this.motion,this.numbers,e),this.legend(),this.curves.point(e),Ke("table-panel").hidden||this.tell()}tell(){this.cells.forEach((t,e)=>t.textContent=uf(this.head.columns[e],this.numbers[e]))}again(){this.influence.rest(this.sliders.parameters,this.sliders.inputs),this.live?.run(this.sliders.parameters,this.sliders.inputs),this.arrows?.then(t=>t?.run(this.sliders.parameters,this.sliders.inputs))}async point(t,e){let n=this.stage.overlay;if(n!==null){if(e?n.shown.add(t):n.shown.delete(t),e&&this.arrows===null){let s=({motion:r})=>{n.take(r),document.documentElement.dataset.arrows=`${r.count}`,this.pose(this.player.time)};this.arrows=sr.begin(this.head,K0,s,{tape:"vectors"}),await this.arrows===null&&this.say("Arrows need WebAssembly."),this.again()}this.pose(this.player.time)}}mark(t){let e=this.head.scene.shapes.filter(({span:n})=>n!==null&&t.some(s=>Fh(s,n)));this.stage.highlight(e),this.source.mark(t),Ke("pointed").textContent=e.map(n=>n.name).join(", ")}follow(t){this.mark(t===null?[]:[t]),this.terms.mark(t)}toSource(t){Ke("source-tab").click(),this.source.pin(t)}toTerms(t){let e=this.terms.first(t);if(e===null){this.say("No term of the equations comes from this line.");return}Ke("derivation-tab").click(),this.terms.pin(t),e.scrollIntoView({block:"center"})}fit(){this.stage.lookAt(),this.pose(this.player.time)}legend(){let t=(this.stage.overlay?.legend()??[]).join(`
`),e=Ke("legend");e.textContent!==t&&(e.textContent=t)}arrived({motion:t,status:e,time:n,took:s}){t.count>0&&(this.motion=t,this.curves.show(t),this.player.mark([]),this.stage.follow(t),this.haunt(),this.pose(this.player.time)),document.documentElement.dataset.took=s.toFixed(2),e===0?this.say(`Integrated anew in ${s.toFixed(1)} ms.`):e===-1?this.say(`This motion takes long; it is shown up to ${n.toPrecision(4)} s.`):this.say(`${this.head.words[e]??`The run ended with status ${e}.`} (t = ${n.toPrecision(5)} s)`)}say(t){Ke("said").textContent=t}values(){let t=Ke("values");return this.head.columns.slice(0,this.head.scene.first).map(e=>{let n=document.createElement("tr"),s=document.createElement("th");s.scope="row",s.textContent=e.name;let r=document.createElement("td"),o=document.createElement("td");return o.textContent=e.display.unit,n.append(s,r,o),t.append(n),r})}tools(){let t=gf(Ke("tools")),e=(n,s)=>{let r=t(n,s,()=>{this.stage.shown[n]=!this.stage.shown[n],r.ariaPressed=`${this.stage.shown[n]}`,this.stage.show(),this.pose(this.player.time)});r.ariaPressed=`${this.stage.shown[n]}`};this.head.scene.shapes.some(({kind:n})=>n==="force"||n==="torque")&&e("forces","Arrows of loads"),this.switches(t),this.head.scene.shapes.some(({kind:n})=>n==="frame")&&e("frames","Axes of frames"),this.ghostly=t("ghosts","Pale postures of several instants (key g)",()=>this.toggleGhosts()),this.ghostly.ariaPressed="false",t("fit","The whole machine (key f)",()=>this.fit()),t("keys",Q0,()=>this.say(Q0)),this.saving()}saving(){let t=gf(J0(Ke("tools"),"save"));if(t("PNG","The picture",()=>fm(this.stage.canvas,this.head)),t("SVG","The picture as lines and faces",()=>kr(new Blob([this.stage.sketch()],{type:"image/svg+xml"}),`${this.head.name}.svg`)),t("GIF","The motion as a film that plays everywhere",()=>{this.filmed()}),t("CSV","The values",()=>pm(this.motion,this.head)),typeof MediaRecorder>"u")return;let e=t("film","Record what plays",()=>{this.endFilm===null?(this.endFilm=mm(this.stage.canvas,this.head),this.player.play()):(this.endFilm(),this.endFilm=null),e.ariaPressed=`${this.endFilm!==null}`})}switches(t){let e=this.stage.overlay;if(e===null)return;for(let[s,r,o]of U0){if(!e.has(s))continue;let a=t(r,o,()=>{let l=!e.shown.has(s);a.ariaPressed=`${l}`,this.point(s,l),s==="admissible"&&(n.hidden=!l)});a.ariaPressed="false",s==="velocity"&&(this.speedy=a)}let n=document.createElement("select");n.title="The coordinate that moves",n.ariaLabel=n.title,n.hidden=!0,n.append(new Option("all coordinates",""),...e.coordinates.map(s=>new Option(s,s))),n.onchange=()=>{e.coordinate=n.value,this.pose(this.player.time)},Ke("tools").append(n)}toggleGhosts(){this.ghosts=!this.ghosts,this.ghostly!==null&&(this.ghostly.ariaPressed=`${this.ghosts}`),this.haunt(),this.pose(this.player.time)}async filmed(){this.player.pause();let{canvas:t}=this.stage,e=document.createElement("canvas");e.width=Math.min(rT,t.width),e.height=Math.round(e.width*t.height/t.width);let n=e.getContext("2d",{willReadFrequently:!0});if(n===null)return;let{time:s}=this.player,r=this.motion.at(0,0),o=this.motion.last-r,a=[];for(let c=0;c<Oh;++c)this.pose(r+o*c/(Oh-1)),n.drawImage(t,0,0,e.width,e.height),a.push(n.getImageData(0,0,e.width,e.height)),c%8===0&&(this.say(`Film: ${c+1} of ${Oh} pictures`),await new Promise(h=>setTimeout(h)));let l=Math.min(Math.max(o,3),10);kr(gm(a,1e3*l/Oh),`${this.head.name}.gif`),this.say("The film is saved."),this.pose(s)}keys(){document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.target instanceof HTMLInputElement||t.target instanceof HTMLSelectElement)return;let n={" ":()=>this.player.toggle(),ArrowRight:()=>this.player.step(.01),ArrowLeft:()=>this.player.step(-.01),"+":()=>this.player.faster(1),"-":()=>this.player.faster(-1),g:()=>this.toggleGhosts(),v:()=>this.speedy?.click(),f:()=>this.fit(),Home:()=>this.player.go(-1/0),End:()=>this.player.go(1/0)}[t.key];n===void 0||t.key===" "&&t.target instanceof HTMLButtonElement||(t.preventDefault(),n())})}pointer(){let t=null;this.stage.canvas.addEventListener("pointermove",e=>{if(e.buttons!==0)return;let n=this.stage.shapeAt(e.clientX,e.clientY);if(n===t)return;t=n,this.stage.highlight(n===null?[]:[n]),this.source.mark(n?.span?[n.span]:[]),this.terms.mark(n?.span??null);let s=n===null?"":this.stage.value(n,this.numbers);Ke("pointed").textContent=[n?.name??"",s].filter(r=>r!=="").join(": ")})}};function aT(){return new Promise(i=>{requestAnimationFrame(()=>setTimeout(i)),setTimeout(i,oT)})}async function lT(){let i=xm(),t=await Promise.all(i.meshes.map(S0)),e=ym(i,await Gr("motion")),n=new Nh(i,Au(e),t,Ke("stage")),[s]=e;n.pose(s,s.state(i.start,new Float64Array(s.width)),i.start),await aT(),await new _f(i,e,n).begin()}lT().catch(i=>{Ke("said").textContent=`The page cannot be shown: ${String(i)}`});})();
