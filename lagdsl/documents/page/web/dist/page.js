"use strict";(()=>{var w_="uplot",T_="u-hz",A_="u-vt",E_="u-title",C_="u-wrap",R_="u-under",P_="u-over",I_="u-axis",nr="u-off",L_="u-select",D_="u-cursor-x",N_="u-cursor-y",U_="u-cursor-pt",O_="u-legend",F_="u-live",B_="u-inline",k_="u-series",z_="u-marker",Vf="u-label",G_="u-value",Ho="width",Vo="height";var Wf="bottom",Dr="left",Qh="right",gu="#000",Xf=gu+"0",eu="mousemove",qf="mousedown",tu="mouseup",Yf="mouseenter",$f="mouseleave",Zf="dblclick",H_="resize",V_="scroll",Jf="change",sl="dppxchange",_u="--",zr=typeof window<"u",ou=zr?document:null,Ur=zr?window:null,W_=zr?navigator:null,It,el;function au(){let i=devicePixelRatio;It!=i&&(It=i,el&&cu(Jf,el,au),el=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),ir(Jf,el,au),Ur.dispatchEvent(new CustomEvent(sl)))}function ii(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function lu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Jt(i,e,t){i.style[e]=t+"px"}function Ai(i,e,t,n){let s=ou.createElement(i);return e!=null&&ii(s,e),t?.insertBefore(s,n),s}function _i(i,e){return Ai("div",i,e)}var Kf=new WeakMap;function Yi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Kf.get(i);r!=o&&(i.style.transform=r,Kf.set(i,r),e<0||t<0||e>n||t>s?ii(i,nr):lu(i,nr))}var jf=new WeakMap;function Qf(i,e,t){let n=e+t,s=jf.get(i);n!=s&&(jf.set(i,n),i.style.background=e,i.style.borderColor=t)}var ep=new WeakMap;function tp(i,e,t,n){let s=e+""+t,r=ep.get(i);s!=r&&(ep.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var xu={passive:!0},X_={...xu,capture:!0};function ir(i,e,t,n){e.addEventListener(i,t,n?X_:xu)}function cu(i,e,t,n){e.removeEventListener(i,t,xu)}zr&&au();function Ei(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:si((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Rp(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Pp=i=>i!=null,Ip=i=>i!=null&&i>0,al=Rp(Pp),q_=Rp(Ip);function Y_(i,e,t,n=0,s=!1){let r=s?q_:al,o=s?Ip:Pp;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Vt,l??-Vt]}function ll(i,e,t,n){let s=sp(i),r=sp(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ls:Lp,a=s==1?si:xi,l=r==1?xi:si,c=a(o(_n(i))),h=l(o(_n(e))),u=Or(t,c),d=Or(t,h);return t==10&&(c<0&&(u=Wt(u,-c)),h<0&&(d=Wt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=Op(i,u),e=cl(e,d)),[i,e]}function yu(i,e,t,n){let s=ll(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var vu=.1,np={mode:3,pad:vu},Xo={pad:0,soft:null,mode:0},$_={min:Xo,max:Xo};function rl(i,e,t,n){return hl(t)?ip(i,e,t):(Xo.pad=t,Xo.soft=n?0:null,Xo.mode=n?3:0,ip(i,e,$_))}function Ct(i,e){return i??e}function Z_(i,e,t){for(e=Ct(e,0),t=Ct(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function ip(i,e,t){let n=t.min,s=t.max,r=Ct(n.pad,0),o=Ct(s.pad,0),a=Ct(n.hard,-Vt),l=Ct(s.hard,Vt),c=Ct(n.soft,Vt),h=Ct(s.soft,-Vt),u=Ct(n.mode,0),d=Ct(s.mode,0),f=e-i,g=ls(f),M=Gn(_n(i),_n(e)),m=ls(M),p=_n(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Vt&&(r=0),d==2&&h!=-Vt&&(o=0)));let b=f||M||1e3,C=ls(b),v=Or(10,si(C)),R=b*(f==0?i==0?.1:1:r),E=Wt(Op(i-R,v/10),24),_=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Vt,T=Gn(a,E<_&&i>=_?_:Ci(_,E)),B=b*(f==0?e==0?.1:1:o),N=Wt(cl(e+B,v/10),24),D=e<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-Vt,k=Ci(l,N>D&&e<=D?D:Gn(D,N));return T==k&&T==0&&(k=100),[T,k]}var J_=new Intl.NumberFormat(zr?W_.language:"en-US"),bu=i=>J_.format(i),ri=Math,il=ri.PI,_n=ri.abs,si=ri.floor,gn=ri.round,xi=ri.ceil,Ci=ri.min,Gn=ri.max,Or=ri.pow,sp=ri.sign,ls=ri.log10,Lp=ri.log2,K_=(i,e=1)=>ri.sinh(i)*e,nu=(i,e=1)=>ri.asinh(i/e),Vt=1/0;function rp(i){return(ls((i^i>>31)-(i>>31))|0)+1}function hu(i,e,t){return Ci(Gn(i,e),t)}function Dp(i){return typeof i=="function"}function Tt(i){return Dp(i)?i:()=>i}var j_=()=>{},Np=i=>i,Up=(i,e)=>e,Q_=i=>null,op=i=>!0,ap=(i,e)=>i==e,ex=/\.\d*?(?=9{6,}|0{6,})/gm,sr=i=>{if(Bp(i)||Us.has(i))return i;let e=`${i}`,t=e.match(ex);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${sr(s)}e${r}`}return Wt(i,n)};function er(i,e){return sr(Wt(sr(i/e))*e)}function cl(i,e){return sr(xi(sr(i/e))*e)}function Op(i,e){return sr(si(sr(i/e))*e)}function Wt(i,e=0){if(Bp(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return gn(n)/t}var Us=new Map;function Fp(i){return((""+i).split(".")[1]||"").length}function Yo(i,e,t,n){let s=[],r=n.map(Fp);for(let o=e;o<t;o++){let a=_n(o),l=Wt(Or(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Wt(h,u);s.push(d),Us.set(d,u)}}return s}var qo={},Mu=[],Fr=[null,null],Ns=Array.isArray,Bp=Number.isInteger,tx=i=>i===void 0;function lp(i){return typeof i=="string"}function hl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function nx(i){return i!=null&&typeof i=="object"}var ix=Object.getPrototypeOf(Uint8Array),kp="__proto__";function Br(i,e=hl){let t;if(Ns(i)){let n=i.find(s=>s!=null);if(Ns(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Br(i[s],e)}else t=i.slice()}else if(i instanceof ix)t=i.slice();else if(e(i)){t={};for(let n in i)n!=kp&&(t[n]=Br(i[n],e))}else t=i;return t}function fn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=kp&&(hl(i[s])?fn(i[s],Br(n[s])):i[s]=Br(n[s]))}return i}var sx=0,rx=1,ox=2;function ax(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function lx(i,e){if(ux(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return dx(o[0])||(o=hx(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:rx,f=[];for(let g=0;g<h.length;g++){let M=h[g],m=r.get(l[g]);M===null?d!=sx&&(u[m]=M,d==ox&&f.push(m)):u[m]=M}ax(u,f,s),n.push(u)}}return n}var cx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function hx(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function ux(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function dx(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Gn(1,si((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var zp=["January","February","March","April","May","June","July","August","September","October","November","December"],Gp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Hp(i){return i.slice(0,3)}var fx=Gp.map(Hp),px=zp.map(Hp),mx={MMMM:zp,MMM:px,WWWW:Gp,WWW:fx};function Go(i){return(i<10?"0":"")+i}function gx(i){return(i<10?"00":i<100?"0":"")+i}var _x={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Go(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Go(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Go(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Go(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Go(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>gx(i.getMilliseconds())};function Su(i,e){e=e||mx;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?_x[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var xx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function yx(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==xx?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Vp=i=>i%1==0,ol=[1,2,2.5,5],vx=Yo(10,-32,0,ol),Wp=Yo(10,0,32,ol),bx=Wp.filter(Vp),tr=vx.concat(Wp),wu=`
`,Xp="{YYYY}",cp=wu+Xp,qp="{M}/{D}",Wo=wu+qp,tl=Wo+"/{YY}",Yp="{aa}",Mx="{h}:{mm}",Nr=Mx+Yp,hp=wu+Nr,up=":{ss}",Nt=null;function $p(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Yo(10,0,3,ol).filter(Vp):Yo(10,-3,0,ol)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Xp,Nt,Nt,Nt,Nt,Nt,Nt,1],[s*28,"{MMM}",cp,Nt,Nt,Nt,Nt,Nt,1],[s,qp,cp,Nt,Nt,Nt,Nt,Nt,1],[n,"{h}"+Yp,tl,Nt,Wo,Nt,Nt,Nt,1],[t,Nr,tl,Nt,Wo,Nt,Nt,Nt,1],[e,up,tl+" "+Nr,Nt,Wo+" "+Nr,Nt,hp,Nt,1],[i,up+".{fff}",tl+" "+Nr,Nt,Wo+" "+Nr,Nt,hp,Nt,1]];function h(u){return(d,f,g,M,m,p)=>{let b=[],C=m>=o,v=m>=r&&m<o,R=u(g),E=Wt(R*i,3),_=iu(R.getFullYear(),C?0:R.getMonth(),v||C?1:R.getDate()),T=Wt(_*i,3);if(v||C){let B=v?m/r:0,N=C?m/o:0,D=E==T?E:Wt(iu(_.getFullYear()+N,_.getMonth()+B,1)*i,3),k=new Date(gn(D/i)),W=k.getFullYear(),L=k.getMonth();for(let H=0;D<=M;H++){let q=iu(W+N*H,L+B*H,1),V=q-u(Wt(q*i,3));D=Wt((+q+V)*i,3),D<=M&&b.push(D)}}else{let B=m>=s?s:m,N=si(g)-si(E),D=T+N+cl(E-T,B);b.push(D);let k=u(D),W=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,L=m/n,H=d.axes[f]._space,q=p/H;for(;D=Wt(D+m,i==1?0:3),!(D>M);)if(L>1){let V=si(Wt(W+L,6))%24,j=u(D).getHours()-V;j>1&&(j=-1),D-=j*n,W=(W+L)%24;let ie=b[b.length-1];Wt((D-ie)/m,3)*q>=.7&&b.push(D)}else b.push(D)}return b}}return[l,c,h]}var[Sx,wx,Tx]=$p(1),[Ax,Ex,Cx]=$p(.001);Yo(2,-53,53,[1]);function dp(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function fp(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let M=i(g),m=M.getFullYear(),p=M.getMonth(),b=M.getDate(),C=M.getHours(),v=M.getMinutes(),R=M.getSeconds(),E=m!=l&&a[2]||p!=c&&a[3]||b!=h&&a[4]||C!=u&&a[5]||v!=d&&a[6]||R!=f&&a[7]||a[1];return l=m,c=p,h=b,u=C,d=v,f=R,E(M)})}}function Rx(i,e){let t=Su(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function iu(i,e,t){return new Date(i,e,t)}function pp(i,e){return e(i)}var Px="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function mp(i,e){return(t,n,s,r)=>r==null?_u:e(i(n))}function Ix(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Lx(i,e){return i.series[e].fill(i,e)}var Dx={show:!0,live:!0,isolate:!1,mount:j_,markers:{show:!0,width:2,stroke:Ix,fill:Lx,dash:"solid"},idx:null,idxs:null,values:[]};function Nx(i,e){let t=i.cursor.points,n=_i(),s=t.size(i,e);Jt(n,Ho,s),Jt(n,Vo,s);let r=s/-2;Jt(n,"marginLeft",r),Jt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Jt(n,"borderWidth",o),n}function Ux(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Ox(i,e){let t=i.series[e].points;return t._stroke||t._fill}function Fx(i,e){return i.series[e].points.size}var su=[0,0];function Bx(i,e,t){return su[0]=e,su[1]=t,su}function nl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ru(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var kx={show:!0,x:!0,y:!0,lock:!1,move:Bx,points:{one:!1,show:Nx,size:Fx,width:0,stroke:Ox,fill:Ux},bind:{mousedown:nl,mouseup:nl,click:nl,dblclick:nl,mousemove:ru,mouseleave:ru,mouseenter:ru},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Zp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Tu=fn({},Zp,{filter:Up}),Jp=fn({},Tu,{size:10}),Kp=fn({},Zp,{show:!1}),Au='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jp="bold "+Au,Qp=1.5,gp={show:!0,scale:"x",stroke:gu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jp,side:2,grid:Tu,ticks:Jp,border:Kp,font:Au,lineGap:Qp,rotate:0},zx="Value",Gx="Time",_p={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function Hx(i,e,t,n,s){return e.map(r=>r==null?"":bu(r))}function Vx(i,e,t,n,s,r,o){let a=[],l=Us.get(s)||0;t=o?t:Wt(cl(t,s),l);for(let c=t;c<=n;c=Wt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function uu(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ls:Lp,h=si(c(t));s=Or(l,h),l==10&&(s=tr[Ei(s,tr)]);let u=t,d=s*l;l==10&&(d=tr[Ei(d,tr)]);do a.push(u),u=u+s,l==10&&!Us.has(u)&&(u=Wt(u,Us.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=tr[Ei(d,tr)]));while(u<=n);return a}function Wx(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?uu(i,e,Gn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?uu(i,e,Gn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var em=/./,Xx=/[12357]/,qx=/[125]/,xp=/1/,du=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Yx(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?em:l(7,o)-h>=c?Xx:l(5,o)-h>=c?qx:xp;if(u==xp){let d=_n(l(1,o)-h);if(d<c)return du(e.slice().reverse(),a.distr,u,xi(c/d)).reverse()}return du(e,a.distr,u,1)}function $x(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=_n(l(1,o)-l(2,o));return c<a?du(e.slice().reverse(),3,em,xi(a/c)).reverse():e}function Zx(i,e,t,n){return n==null?_u:e==null?"":bu(e)}var yp={show:!0,scale:"y",stroke:gu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jp,side:3,grid:Tu,ticks:Jp,border:Kp,font:Au,lineGap:Qp,rotate:0};function Jx(i,e){let t=3+(i||1)*2;return Wt(t*e,3)}function Kx(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=_n(o-r),l=i.series[e],c=a/(l.points.space*It);return n[1]-n[0]<=c}var vp={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},tm=(i,e,t,n,s)=>s,bp={show:!0,auto:!0,sorted:0,gaps:tm,alpha:1,facets:[fn({},vp,{scale:"x"}),fn({},vp,{scale:"y"})]},Mp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:tm,alpha:1,points:{show:Kx,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function jx(i,e,t,n,s){return t/10}var nm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Qx=fn({},nm,{time:!1,ori:1}),Sp={};function im(i,e){let t=Sp[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Sp[i]=t)),t}var kr=1,fu=2;function rr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,M=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,p,d,f,g,M,dl,Gr,pl,rm,am):t(s,l,c,h,u,p,m,f,d,M,g,fl,Hr,Ru,om,lm)}function Eu(i,e){let t=0,n=0,s=Ct(i.bands,Mu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function ey(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function cs(i,e,t,n,s,r){return rr(i,e,(o,a,l,c,h,u,d,f,g,M,m)=>{let p=o.pxRound,b=c.dir*(c.ori==0?1:-1),C=c.ori==0?Gr:Hr,v,R;b==1?(v=t,R=n):(v=n,R=t);let E=p(u(a[v],c,M,f)),_=p(d(l[v],h,m,g)),T=p(u(a[R],c,M,f)),B=p(d(r==1?h.max:h.min,h,m,g)),N=new Path2D(s);return C(N,T,B),C(N,E,B),C(N,E,_),N})}function ul(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?pl:Ru,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function ty(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Cu(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),M=u-s;f=o<=0&&M>=0&&M<l?r(i[M]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function wp(i){return i==0?Np:i==1?gn:e=>er(e,i)}function sm(i){let e=i==0?dl:fl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ci(c,a/2,l/2),h=Ci(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var dl=(i,e,t)=>{i.moveTo(e,t)},fl=(i,e,t)=>{i.moveTo(t,e)},Gr=(i,e,t)=>{i.lineTo(e,t)},Hr=(i,e,t)=>{i.lineTo(t,e)},pl=sm(0),Ru=sm(1),rm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},om=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},am=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},lm=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function cm(i){return(e,t,n,s,r)=>rr(e,t,(o,a,l,c,h,u,d,f,g,M,m)=>{let{pxRound:p,points:b}=o,C,v;c.ori==0?(C=dl,v=rm):(C=fl,v=om);let R=Wt(b.width*It,3),E=(b.size-b.width)/2*It,_=Wt(E*2,3),T=new Path2D,B=new Path2D,{left:N,top:D,width:k,height:W}=e.bbox;pl(B,N-_,D-_,k+_*2,W+_*2);let L=H=>{if(l[H]!=null){let q=p(u(a[H],c,M,f)),V=p(d(l[H],h,m,g));C(T,q+E,V),v(T,q,V,E,0,il*2)}};if(r)r.forEach(L);else for(let H=n;H<=s;H++)L(H);return{stroke:R>0?T:null,fill:T,clip:B,flags:kr|fu}})}function hm(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var ny=hm(Gr),iy=hm(Hr);function um(i){let e=Ct(i?.alignGaps,0);return(t,n,s,r)=>rr(t,n,(o,a,l,c,h,u,d,f,g,M,m)=>{[s,r]=al(l,s,r);let p=o.pxRound,b=W=>p(u(W,c,M,f)),C=W=>p(d(W,h,m,g)),v,R;c.ori==0?(v=Gr,R=ny):(v=Hr,R=iy);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:kr},T=_.stroke,B=!1;if(r-s>=M*4){let W=he=>t.posToVal(he,c.key,!0),L=null,H=null,q,V,ce,Y=b(a[E==1?s:r]),j=b(a[s]),ie=b(a[r]),pe=W(E==1?j+1:ie-1);for(let he=E==1?s:r;he>=s&&he<=r;he+=E){let ee=a[he],Me=(E==1?ee<pe:ee>pe)?Y:b(ee),Le=l[he];Me==Y?Le!=null?(V=Le,L==null?(v(T,Me,C(V)),q=L=H=V):V<L?L=V:V>H&&(H=V)):Le===null&&(B=!0):(L!=null&&R(T,Y,C(L),C(H),C(q),C(V)),Le!=null?(V=Le,v(T,Me,C(V)),L=H=q=V):(L=H=null,Le===null&&(B=!0)),Y=Me,pe=W(Y+E))}L!=null&&L!=H&&ce!=Y&&R(T,Y,C(L),C(H),C(q),C(V))}else for(let W=E==1?s:r;W>=s&&W<=r;W+=E){let L=l[W];L===null?B=!0:L!=null&&v(T,b(a[W]),C(L))}let[D,k]=Eu(t,n);if(o.fill!=null||D!=0){let W=_.fill=new Path2D(T),L=o.fillTo(t,n,o.min,o.max,D),H=C(L),q=b(a[s]),V=b(a[r]);E==-1&&([V,q]=[q,V]),v(W,V,H),v(W,q,H)}if(!o.spanGaps){let W=[];B&&W.push(...Cu(a,l,s,r,E,b,e)),_.gaps=W=o.gaps(t,n,s,r,W),_.clip=ul(W,c.ori,f,g,M,m)}return k!=0&&(_.band=k==2?[cs(t,n,s,r,T,-1),cs(t,n,s,r,T,1)]:cs(t,n,s,r,T,k)),_})}function sy(i){let e=Ct(i.align,1),t=Ct(i.ascDesc,!1),n=Ct(i.alignGaps,0),s=Ct(i.extend,!1);return(r,o,a,l)=>rr(r,o,(c,h,u,d,f,g,M,m,p,b,C)=>{[a,l]=al(u,a,l);let v=c.pxRound,{left:R,width:E}=r.bbox,_=j=>v(g(j,d,b,m)),T=j=>v(M(j,f,C,p)),B=d.ori==0?Gr:Hr,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:kr},D=N.stroke,k=d.dir*(d.ori==0?1:-1),W=T(u[k==1?a:l]),L=_(h[k==1?a:l]),H=L,q=L;s&&e==-1&&(q=R,B(D,q,W)),B(D,L,W);for(let j=k==1?a:l;j>=a&&j<=l;j+=k){let ie=u[j];if(ie==null)continue;let pe=_(h[j]),he=T(ie);e==1?B(D,pe,W):B(D,H,he),B(D,pe,he),W=he,H=pe}let V=H;s&&e==1&&(V=R+E,B(D,V,W));let[ce,Y]=Eu(r,o);if(c.fill!=null||ce!=0){let j=N.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,ce),pe=T(ie);B(j,V,pe),B(j,q,pe)}if(!c.spanGaps){let j=[];j.push(...Cu(h,u,a,l,k,_,n));let ie=c.width*It/2,pe=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;j.forEach(ee=>{ee[0]+=pe,ee[1]+=he}),N.gaps=j=c.gaps(r,o,a,l,j),N.clip=ul(j,d.ori,m,p,b,C)}return Y!=0&&(N.band=Y==2?[cs(r,o,a,l,D,-1),cs(r,o,a,l,D,1)]:cs(r,o,a,l,D,Y)),N})}function Tp(i,e,t,n,s,r,o=Vt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=_n(i[l]-i[a]);h<c&&(c=h,o=_n(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function ry(i){i=i||qo;let e=Ct(i.size,[.6,Vt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Tt(s),o=1-e[0],a=Ct(e[1],Vt),l=Ct(e[2],1),c=Ct(i.disp,qo),h=Ct(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,M,m)=>rr(f,g,(p,b,C,v,R,E,_,T,B,N,D)=>{let k=p.pxRound,W=t,L=n*It,H=a*It,q=l*It,V,ce;v.ori==0?[V,ce]=r(f,g):[ce,V]=r(f,g);let Y=v.dir*(v.ori==0?1:-1),j=v.ori==0?pl:Ru,ie=v.ori==0?h:(ue,ze,Ue,ye,qe,Te,Ge)=>{h(ue,ze,Ue,qe,ye,Ge,Te)},pe=Ct(f.bands,Mu).find(ue=>ue.series[0]==g),he=pe!=null?pe.dir:0,ee=p.fillTo(f,g,p.min,p.max,he),ge=k(_(ee,R,D,B)),Me,Le,Ee,je=N,ut=k(p.width*It),Je=!1,ft=null,pt=null,ot=null,Ot=null;u!=null&&(ut==0||d!=null)&&(Je=!0,ft=u.values(f,g,M,m),pt=new Map,new Set(ft).forEach(ue=>{ue!=null&&pt.set(ue,new Path2D)}),ut>0&&(ot=d.values(f,g,M,m),Ot=new Map,new Set(ot).forEach(ue=>{ue!=null&&Ot.set(ue,new Path2D)})));let{x0:Dt,size:qt}=c;if(Dt!=null&&qt!=null){W=1,b=Dt.values(f,g,M,m),Dt.unit==2&&(b=b.map(Ue=>f.posToVal(T+Ue*N,v.key,!0)));let ue=qt.values(f,g,M,m);qt.unit==2?Le=ue[0]*N:Le=E(ue[0],v,N,T)-E(0,v,N,T),je=Tp(b,C,E,v,N,T,je),Ee=je-Le+L}else je=Tp(b,C,E,v,N,T,je),Ee=je*o+L,Le=je-Ee;Ee<1&&(Ee=0),ut>=Le/2&&(ut=0),Ee<5&&(k=Np);let K=Ee>0,de=je-Ee-(K?ut:0);Le=k(hu(de,q,H)),Me=(W==0?Le/2:W==Y?0:Le)-W*Y*((W==0?L/2:0)+(K?ut/2:0));let xe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Se=Je?null:new Path2D,_e=null;if(pe!=null)_e=f.data[pe.series[1]];else{let{y0:ue,y1:ze}=c;ue!=null&&ze!=null&&(C=ze.values(f,g,M,m),_e=ue.values(f,g,M,m))}let $e=V*Le,P=ce*Le;for(let ue=Y==1?M:m;ue>=M&&ue<=m;ue+=Y){let ze=C[ue];if(ze==null)continue;if(_e!=null){let z=_e[ue]??0;if(ze-z==0)continue;ge=_(z,R,D,B)}let Ue=v.distr!=2||c!=null?b[ue]:ue,ye=E(Ue,v,N,T),qe=_(Ct(ze,ee),R,D,B),Te=k(ye-Me),Ge=k(Gn(qe,ge)),A=k(Ci(qe,ge)),y=Ge-A;if(ze!=null){let z=ze<0?P:$e,se=ze<0?$e:P;Je?(ut>0&&ot[ue]!=null&&j(Ot.get(ot[ue]),Te,A+si(ut/2),Le,Gn(0,y-ut),z,se),ft[ue]!=null&&j(pt.get(ft[ue]),Te,A+si(ut/2),Le,Gn(0,y-ut),z,se)):j(Se,Te,A+si(ut/2),Le,Gn(0,y-ut),z,se),ie(f,g,ue,Te-ut/2,A,Le+ut,y)}}return ut>0?xe.stroke=Je?Ot:Se:Je||(xe._fill=p.width==0?p._fill:p._stroke??p._fill,xe.width=0),xe.fill=Je?pt:Se,xe})}function oy(i,e){let t=Ct(e?.alignGaps,0);return(n,s,r,o)=>rr(n,s,(a,l,c,h,u,d,f,g,M,m,p)=>{[r,o]=al(c,r,o);let b=a.pxRound,C=V=>b(d(V,h,m,g)),v=V=>b(f(V,u,p,M)),R,E,_;h.ori==0?(R=dl,_=Gr,E=am):(R=fl,_=Hr,E=lm);let T=h.dir*(h.ori==0?1:-1),B=C(l[T==1?r:o]),N=B,D=[],k=[];for(let V=T==1?r:o;V>=r&&V<=o;V+=T)if(c[V]!=null){let Y=l[V],j=C(Y);D.push(N=j),k.push(v(c[V]))}let W={stroke:i(D,k,R,_,E,b),fill:null,clip:null,band:null,gaps:null,flags:kr},L=W.stroke,[H,q]=Eu(n,s);if(a.fill!=null||H!=0){let V=W.fill=new Path2D(L),ce=a.fillTo(n,s,a.min,a.max,H),Y=v(ce);_(V,N,Y),_(V,B,Y)}if(!a.spanGaps){let V=[];V.push(...Cu(l,c,r,o,T,C,t)),W.gaps=V=a.gaps(n,s,r,o,V),W.clip=ul(V,h.ori,g,M,m,p)}return q!=0&&(W.band=q==2?[cs(n,s,r,o,L,-1),cs(n,s,r,o,L,1)]:cs(n,s,r,o,L,q)),W})}function ay(i){return oy(ly,i)}function ly(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var pu=new Set;function Ap(){for(let i of pu)i.syncRect(!0)}zr&&(ir(H_,Ur,Ap),ir(V_,Ur,Ap,!0),ir(sl,Ur,()=>{xn.pxRatio=It}));var cy=um(),hy=cm();function Ep(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>mu(r,o,e,t))}function uy(i,e){return i.map((t,n)=>n==0?{}:fn({},e,t))}function mu(i,e,t,n){return fn({},e==0?t:n,i)}function dm(i,e,t){return e==null?Fr:[e,t]}var dy=dm;function fy(i,e,t){return e==null?Fr:rl(e,t,vu,!0)}function fm(i,e,t,n){return e==null?Fr:ll(e,t,i.scales[n].log,!1)}var py=fm;function pm(i,e,t,n){return e==null?Fr:yu(e,t,i.scales[n].log,!1)}var my=pm;function gy(i,e,t,n,s){let r=Gn(rp(i),rp(e)),o=e-i,a=Ei(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Us.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Cp(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=gn((t=+s)*It))+"px"),[i,e,t]}function _y(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Wt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function xn(i,e,t){let n={mode:Ct(i.mode,1)},s=n.mode;function r(x,S,I,U){let X=S.valToPct(x);return U+I*(S.dir==-1?1-X:X)}function o(x,S,I,U){let X=S.valToPct(x);return U+I*(S.dir==-1?X:1-X)}function a(x,S,I,U){return S.ori==0?r(x,S,I,U):o(x,S,I,U)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=_i(w_);if(i.id!=null&&(c.id=i.id),ii(c,i.class),i.title){let x=_i(E_,c);x.textContent=i.title}let h=Ai("canvas"),u=n.ctx=h.getContext("2d"),d=_i(C_,c);ir("click",d,x=>{x.target===g&&(Yt!=Cr||jt!=Rr)&&Pn.click(n,x)},!0);let f=n.under=_i(R_,d);d.appendChild(h);let g=n.over=_i(P_,d);i=Br(i);let M=+Ct(i.pxAlign,1),m=wp(M);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let p=i.ms||.001,b=n.series=s==1?Ep(i.series||[],_p,Mp,!1):uy(i.series||[null],bp),C=n.axes=Ep(i.axes||[],gp,yp,!0),v=n.scales={},R=n.bands=i.bands||[];R.forEach(x=>{x.fill=Tt(x.fill||null),x.dir=Ct(x.dir,-1)});let E=s==2?b[1].facets[0].scale:b[0].scale,_={axes:os,series:bt},T=(i.drawOrder||["axes","series"]).map(x=>_[x]);function B(x){let S=x.distr==3?I=>ls(I>0?I:x.clamp(n,I,x.min,x.max,x.key)):x.distr==4?I=>nu(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let U=S(I),{_min:X,_max:J}=x,fe=J-X;return(U-X)/fe}}function N(x){let S=v[x];if(S==null){let I=(i.scales||qo)[x]||qo;if(I.from!=null){N(I.from);let U=fn({},v[I.from],I,{key:x});U.valToPct=B(U),v[x]=U}else{S=v[x]=fn({},x==E?nm:Qx,I),S.key=x;let U=S.time,X=S.range,J=Ns(X);if((x!=E||s==2&&!U)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?np:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?np:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&hl(X))){let fe=X;X=(we,Ie,He)=>Ie==null?Fr:rl(Ie,He,fe)}S.range=Tt(X||(U?dy:x==E?S.distr==3?py:S.distr==4?my:dm:S.distr==3?fm:S.distr==4?pm:fy)),S.auto=Tt(J?!1:S.auto),S.clamp=Tt(S.clamp||jx),S._min=S._max=null,S.valToPct=B(S)}}}N("x"),N("y"),s==1&&b.forEach(x=>{N(x.scale)}),C.forEach(x=>{N(x.scale)});for(let x in i.scales)N(x);let D=v[E],k=D.distr,W,L;D.ori==0?(ii(c,T_),W=r,L=o):(ii(c,A_),W=o,L=r);let H={};for(let x in v){let S=v[x];(S.min!=null||S.max!=null)&&(H[x]={min:S.min,max:S.max},S.min=S.max=null)}let q=i.tzDate||(x=>new Date(gn(x/p))),V=i.fmtDate||Su,ce=p==1?Tx(q):Cx(q),Y=fp(q,dp(p==1?wx:Ex,V)),j=mp(q,pp(Px,V)),ie=[],pe=n.legend=fn({},Dx,i.legend),he=n.cursor=fn({},kx,{drag:{y:s==2}},i.cursor),ee=pe.show,ge=he.show,Me=pe.markers;pe.idxs=ie,Me.width=Tt(Me.width),Me.dash=Tt(Me.dash),Me.stroke=Tt(Me.stroke),Me.fill=Tt(Me.fill);let Le,Ee,je,ut=[],Je=[],ft,pt=!1,ot={};if(pe.live){let x=b[1]?b[1].values:null;pt=x!=null,ft=pt?x(n,1,0):{_:0};for(let S in ft)ot[S]=_u}if(ee)if(Le=Ai("table",O_,c),je=Ai("tbody",null,Le),pe.mount(n,Le),pt){Ee=Ai("thead",null,Le,je);let x=Ai("tr",null,Ee);Ai("th",null,x);for(var Ot in ft)Ai("th",Vf,x).textContent=Ot}else ii(Le,B_),pe.live&&ii(Le,F_);let Dt={show:!0},qt={show:!1};function K(x,S){if(S==0&&(pt||!pe.live||s==2))return Fr;let I=[],U=Ai("tr",k_,je,je.childNodes[S]);ii(U,x.class),x.show||ii(U,nr);let X=Ai("th",null,U);if(Me.show){let we=_i(z_,X);if(S>0){let Ie=Me.width(n,S);Ie&&(we.style.border=Ie+"px "+Me.dash(n,S)+" "+Me.stroke(n,S)),we.style.background=Me.fill(n,S)}}let J=_i(Vf,X);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,S>0&&(Me.show||(J.style.color=x.width>0?Me.stroke(n,S):Me.fill(n,S)),xe("click",X,we=>{if(he._lock)return;st(we);let Ie=b.indexOf(x);if((we.ctrlKey||we.metaKey)!=pe.isolate){let He=b.some((Ve,Ye)=>Ye>0&&Ye!=Ie&&Ve.show);b.forEach((Ve,Ye)=>{Ye>0&&Vi(Ye,He?Ye==Ie?Dt:qt:Dt,!0,dn.setSeries)})}else Vi(Ie,{show:!x.show},!0,dn.setSeries)},!1),tt&&xe(Yf,X,we=>{he._lock||(st(we),Vi(b.indexOf(x),Ir,!0,dn.setSeries))},!1));for(var fe in ft){let we=Ai("td",G_,U);we.textContent="--",I.push(we)}return[U,I]}let de=new Map;function xe(x,S,I,U=!0){let X=de.get(S)||{},J=he.bind[x](n,S,I,U);J&&(ir(x,S,X[x]=J),de.set(S,X))}function Se(x,S,I){let U=de.get(S)||{};for(let X in U)(x==null||X==x)&&(cu(X,S,U[X]),delete U[X]);x==null&&de.delete(S)}let _e=0,$e=0,P=0,ue=0,ze=0,Ue=0,ye=ze,qe=Ue,Te=P,Ge=ue,A=0,y=0,z=0,se=0;n.bbox={};let Q=!1,me=!1,ve=!1,te=!1,re=!1,be=!1;function O(x,S,I){(I||x!=n.width||S!=n.height)&&ae(x,S),_t(!1),ve=!0,me=!0,Dn()}function ae(x,S){n.width=_e=P=x,n.height=$e=ue=S,ze=Ue=0,Re(),Qe();let I=n.bbox;A=I.left=er(ze*It,.5),y=I.top=er(Ue*It,.5),z=I.width=er(P*It,.5),se=I.height=er(ue*It,.5)}let oe=3;function Pe(){let x=!1,S=0;for(;!x;){S++;let I=Tr(S),U=Hi(S);x=S==oe||I&&U,x||(ae(n.width,n.height),me=!0)}}function Ae({width:x,height:S}){O(x,S)}n.setSize=Ae;function Re(){let x=!1,S=!1,I=!1,U=!1;C.forEach((X,J)=>{if(X.show&&X._show){let{side:fe,_size:we}=X,Ie=fe%2,He=X.label!=null?X.labelSize:0,Ve=we+He;Ve>0&&(Ie?(P-=Ve,fe==3?(ze+=Ve,U=!0):I=!0):(ue-=Ve,fe==0?(Ue+=Ve,x=!0):S=!0))}}),zi[0]=x,zi[1]=I,zi[2]=S,zi[3]=U,P-=Si[1]+Si[3],ze+=Si[3],ue-=Si[2]+Si[0],Ue+=Si[0]}function Qe(){let x=ze+P,S=Ue+ue,I=ze,U=Ue;function X(J,fe){switch(J){case 1:return x+=fe,x-fe;case 2:return S+=fe,S-fe;case 3:return I-=fe,I+fe;case 0:return U-=fe,U+fe}}C.forEach((J,fe)=>{if(J.show&&J._show){let we=J.side;J._pos=X(we,J._size),J.label!=null&&(J._lpos=X(we,J.labelSize))}})}if(he.dataIdx==null){let x=he.hover,S=x.skip=new Set(x.skip??[]);S.add(void 0);let I=x.prox=Tt(x.prox),U=x.bias??=0;he.dataIdx=(X,J,fe,we)=>{if(J==0)return fe;let Ie=fe,He=I(X,J,fe,we)??Vt,Ve=He>=0&&He<Vt,Ye=D.ori==0?P:ue,mt=he.left,Pt=e[0],Et=e[J];if(S.has(Et[fe])){Ie=null;let St=null,ct=null,it;if(U==0||U==-1)for(it=fe;St==null&&it-- >0;)S.has(Et[it])||(St=it);if(U==0||U==1)for(it=fe;ct==null&&it++<Et.length;)S.has(Et[it])||(ct=it);if(St!=null||ct!=null)if(Ve){let Zt=St==null?-1/0:W(Pt[St],D,Ye,0),rn=ct==null?1/0:W(Pt[ct],D,Ye,0),An=mt-Zt,Ht=rn-mt;An<=Ht?An<=He&&(Ie=St):Ht<=He&&(Ie=ct)}else Ie=ct==null?St:St==null?ct:fe-St<=ct-fe?St:ct}else Ve&&_n(mt-W(Pt[fe],D,Ye,0))>He&&(Ie=null);return Ie}}let st=x=>{he.event=x};he.idxs=ie,he._lock=!1;let le=he.points;le.show=Tt(le.show),le.size=Tt(le.size),le.stroke=Tt(le.stroke),le.width=Tt(le.width),le.fill=Tt(le.fill);let Fe=n.focus=fn({},i.focus||{alpha:.3},he.focus),tt=Fe.prox>=0,Ce=tt&&le.one,lt=[],Gt=[],Ln=[];function Do(x,S){let I=le.show(n,S);if(I instanceof HTMLElement)return ii(I,U_),ii(I,x.class),Yi(I,-10,-10,P,ue),g.insertBefore(I,lt[S]),I}function Mr(x,S){if(s==1||S>0){let I=s==1&&v[x.scale].time,U=x.value;x.value=I?lp(U)?mp(q,pp(U,V)):U||j:U||Zx,x.label=x.label||(I?Gx:zx)}if(Ce||S>0){x.width=x.width==null?1:x.width,x.paths=x.paths||cy||Q_,x.fillTo=Tt(x.fillTo||ey),x.pxAlign=+Ct(x.pxAlign,M),x.pxRound=wp(x.pxAlign),x.stroke=Tt(x.stroke||null),x.fill=Tt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=Jx(Gn(1,x.width),1),U=x.points=fn({},{size:I,width:Gn(1,I*.2),stroke:x.stroke,space:I*2,paths:hy,_stroke:null,_fill:null},x.points);U.show=Tt(U.show),U.filter=Tt(U.filter),U.fill=Tt(U.fill),U.stroke=Tt(U.stroke),U.paths=Tt(U.paths),U.pxAlign=x.pxAlign}if(ee){let I=K(x,S);ut.splice(S,0,I[0]),Je.splice(S,0,I[1]),pe.values.push(null)}if(ge){ie.splice(S,0,null);let I=null;Ce?S==0&&(I=Do(x,S)):S>0&&(I=Do(x,S)),lt.splice(S,0,I),Gt.splice(S,0,0),Ln.splice(S,0,0)}Tn("addSeries",S)}function Vh(x,S){S=S??b.length,x=s==1?mu(x,S,_p,Mp):mu(x,S,{},bp),b.splice(S,0,x),Mr(b[S],S)}n.addSeries=Vh;function Ja(x){if(b.splice(x,1),ee){pe.values.splice(x,1),Je.splice(x,1);let S=ut.splice(x,1)[0];Se(null,S.firstChild),S.remove()}ge&&(ie.splice(x,1),lt.splice(x,1)[0].remove(),Gt.splice(x,1),Ln.splice(x,1)),Tn("delSeries",x)}n.delSeries=Ja;let zi=[!1,!1,!1,!1];function is(x,S){if(x._show=x.show,x.show){let I=x.side%2,U=v[x.scale];U==null&&(x.scale=I?b[1].scale:E,U=v[x.scale]);let X=U.time;x.size=Tt(x.size),x.space=Tt(x.space),x.rotate=Tt(x.rotate),Ns(x.incrs)&&x.incrs.forEach(fe=>{!Us.has(fe)&&Us.set(fe,Fp(fe))}),x.incrs=Tt(x.incrs||(U.distr==2?bx:X?p==1?Sx:Ax:tr)),x.splits=Tt(x.splits||(X&&U.distr==1?ce:U.distr==3?uu:U.distr==4?Wx:Vx)),x.stroke=Tt(x.stroke),x.grid.stroke=Tt(x.grid.stroke),x.ticks.stroke=Tt(x.ticks.stroke),x.border.stroke=Tt(x.border.stroke);let J=x.values;x.values=Ns(J)&&!Ns(J[0])?Tt(J):X?Ns(J)?fp(q,dp(J,V)):lp(J)?Rx(q,J):J||Y:J||Hx,x.filter=Tt(x.filter||(U.distr>=3&&U.log==10?Yx:U.distr==3&&U.log==2?$x:Up)),x.font=Cp(x.font),x.labelFont=Cp(x.labelFont),x._size=x.size(n,null,S,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(zi[S]=!0,x._el=_i(I_,d))}}function ss(x,S,I,U){let[X,J,fe,we]=I,Ie=S%2,He=0;return Ie==0&&(we||J)&&(He=S==0&&!X||S==2&&!fe?gn(gp.size/3):0),Ie==1&&(X||fe)&&(He=S==1&&!J||S==3&&!we?gn(yp.size/2):0),He}let No=n.padding=(i.padding||[ss,ss,ss,ss]).map(x=>Tt(Ct(x,ss))),Si=n._padding=No.map((x,S)=>x(n,S,zi,0)),nn,an=null,ln=null,Gi=s==1?b[0].idxs:null,Qn=null,Cs=!1;function Uo(x,S){if(e=x??[],n.data=n._data=e,s==2){nn=0;for(let I=1;I<b.length;I++)nn+=e[I][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Qn=e[0],nn=Qn.length;let I=e;if(k==2){I=e.slice();let U=I[0]=Array(nn);for(let X=0;X<nn;X++)U[X]=X}n._data=e=I}if(_t(!0),Tn("setData"),k==2&&(ve=!0),S!==!1){let I=D;I.auto(n,Cs)?Oo():Is(E,I.min,I.max),te=te||he.left>=0,be=!0,Dn()}}n.setData=Uo;function Oo(){Cs=!0;let x,S;s==1&&(nn>0?(an=Gi[0]=0,ln=Gi[1]=nn-1,x=e[0][an],S=e[0][ln],k==2?(x=an,S=ln):x==S&&(k==3?[x,S]=ll(x,x,D.log,!1):k==4?[x,S]=yu(x,x,D.log,!1):D.time?S=x+gn(86400/p):[x,S]=rl(x,S,vu,!0))):(an=Gi[0]=x=null,ln=Gi[1]=S=null)),Is(E,x,S)}let Sr,Rs,wr,w,G,ne,$,Z,De,Oe;function Ne(x,S,I,U,X,J){x??=Xf,I??=Mu,U??="butt",X??=Xf,J??="round",x!=Sr&&(u.strokeStyle=Sr=x),X!=Rs&&(u.fillStyle=Rs=X),S!=wr&&(u.lineWidth=wr=S),J!=G&&(u.lineJoin=G=J),U!=ne&&(u.lineCap=ne=U),I!=w&&u.setLineDash(w=I)}function Be(x,S,I,U){S!=Rs&&(u.fillStyle=Rs=S),x!=$&&(u.font=$=x),I!=Z&&(u.textAlign=Z=I),U!=De&&(u.textBaseline=De=U)}function Ke(x,S,I,U,X=0){if(U.length>0&&x.auto(n,Cs)&&(S==null||S.min==null)){let J=Ct(an,0),fe=Ct(ln,U.length-1),we=I.min==null?Y_(U,J,fe,X,x.distr==3):[I.min,I.max];x.min=Ci(x.min,I.min=we[0]),x.max=Gn(x.max,I.max=we[1])}}let dt={min:null,max:null};function vt(){for(let U in v){let X=v[U];H[U]==null&&(X.min==null||H[E]!=null&&X.auto(n,Cs))&&(H[U]=dt)}for(let U in v){let X=v[U];H[U]==null&&X.from!=null&&H[X.from]!=null&&(H[U]=dt)}H[E]!=null&&_t(!0);let x={};for(let U in H){let X=H[U];if(X!=null){let J=x[U]=Br(v[U],nx);if(X.min!=null)fn(J,X);else if(U!=E||s==2)if(nn==0&&J.from==null){let fe=J.range(n,null,null,U);J.min=fe[0],J.max=fe[1]}else J.min=Vt,J.max=-Vt}}if(nn>0){b.forEach((U,X)=>{if(s==1){let J=U.scale,fe=H[J];if(fe==null)return;let we=x[J];if(X==0){let Ie=we.range(n,we.min,we.max,J);we.min=Ie[0],we.max=Ie[1],an=Ei(we.min,e[0]),ln=Ei(we.max,e[0]),ln-an>1&&(e[0][an]<we.min&&an++,e[0][ln]>we.max&&ln--),U.min=Qn[an],U.max=Qn[ln]}else U.show&&U.auto&&Ke(we,fe,U,e[X],U.sorted);U.idxs[0]=an,U.idxs[1]=ln}else if(X>0&&U.show&&U.auto){let[J,fe]=U.facets,we=J.scale,Ie=fe.scale,[He,Ve]=e[X],Ye=x[we],mt=x[Ie];Ye!=null&&Ke(Ye,H[we],J,He,J.sorted),mt!=null&&Ke(mt,H[Ie],fe,Ve,fe.sorted),U.min=fe.min,U.max=fe.max}});for(let U in x){let X=x[U],J=H[U];if(X.from==null&&(J==null||J.min==null)){let fe=X.range(n,X.min==Vt?null:X.min,X.max==-Vt?null:X.max,U);X.min=fe[0],X.max=fe[1]}}}for(let U in x){let X=x[U];if(X.from!=null){let J=x[X.from];if(J.min==null)X.min=X.max=null;else{let fe=X.range(n,J.min,J.max,U);X.min=fe[0],X.max=fe[1]}}}let S={},I=!1;for(let U in x){let X=x[U],J=v[U];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let fe=J.distr;J._min=fe==3?ls(J.min):fe==4?nu(J.min,J.asinh):fe==100?J.fwd(J.min):J.min,J._max=fe==3?ls(J.max):fe==4?nu(J.max,J.asinh):fe==100?J.fwd(J.max):J.max,S[U]=I=!0}}if(I){b.forEach((U,X)=>{s==2?X>0&&S.y&&(U._paths=null):S[U.scale]&&(U._paths=null)});for(let U in S)ve=!0,Tn("setScale",U);ge&&he.left>=0&&(te=be=!0)}for(let U in H)H[U]=null}function Ze(x){let S=hu(an-1,0,nn-1),I=hu(ln+1,0,nn-1);for(;x[S]==null&&S>0;)S--;for(;x[I]==null&&I<nn-1;)I++;return[S,I]}function bt(){if(nn>0){let x=b.some(S=>S._focus)&&Oe!=Fe.alpha;x&&(u.globalAlpha=Oe=Fe.alpha),b.forEach((S,I)=>{if(I>0&&S.show&&(Qt(I,!1),Qt(I,!0),S._paths==null)){let U=Oe;Oe!=S.alpha&&(u.globalAlpha=Oe=S.alpha);let X=s==2?[0,e[I][0].length-1]:Ze(e[I]);S._paths=S.paths(n,I,X[0],X[1]),Oe!=U&&(u.globalAlpha=Oe=U)}}),b.forEach((S,I)=>{if(I>0&&S.show){let U=Oe;Oe!=S.alpha&&(u.globalAlpha=Oe=S.alpha),S._paths!=null&&Ft(I,!1);{let X=S._paths!=null?S._paths.gaps:null,J=S.points.show(n,I,an,ln,X),fe=S.points.filter(n,I,J,X);(J||fe)&&(S.points._paths=S.points.paths(n,I,an,ln,fe),Ft(I,!0))}Oe!=U&&(u.globalAlpha=Oe=U),Tn("drawSeries",I)}}),x&&(u.globalAlpha=Oe=1)}}function Qt(x,S){let I=S?b[x].points:b[x];I._stroke=I.stroke(n,x),I._fill=I.fill(n,x)}function Ft(x,S){let I=S?b[x].points:b[x],{stroke:U,fill:X,clip:J,flags:fe,_stroke:we=I._stroke,_fill:Ie=I._fill,_width:He=I.width}=I._paths;He=Wt(He*It,3);let Ve=null,Ye=He%2/2;S&&Ie==null&&(Ie=He>0?"#fff":we);let mt=I.pxAlign==1&&Ye>0;if(mt&&u.translate(Ye,Ye),!S){let Pt=A-He/2,Et=y-He/2,St=z+He,ct=se+He;Ve=new Path2D,Ve.rect(Pt,Et,St,ct)}S?We(we,He,I.dash,I.cap,Ie,U,X,fe,J):Bt(x,we,He,I.dash,I.cap,Ie,U,X,fe,Ve,J),mt&&u.translate(-Ye,-Ye)}function Bt(x,S,I,U,X,J,fe,we,Ie,He,Ve){let Ye=!1;Ie!=0&&R.forEach((mt,Pt)=>{if(mt.series[0]==x){let Et=b[mt.series[1]],St=e[mt.series[1]],ct=(Et._paths||qo).band;Ns(ct)&&(ct=mt.dir==1?ct[0]:ct[1]);let it,Zt=null;Et.show&&ct&&Z_(St,an,ln)?(Zt=mt.fill(n,Pt)||J,it=Et._paths.clip):ct=null,We(S,I,U,X,Zt,fe,we,Ie,He,Ve,it,ct),Ye=!0}}),Ye||We(S,I,U,X,J,fe,we,Ie,He,Ve)}let mn=kr|fu;function We(x,S,I,U,X,J,fe,we,Ie,He,Ve,Ye){Ne(x,S,I,U,X),(Ie||He||Ye)&&(u.save(),Ie&&u.clip(Ie),He&&u.clip(He)),Ye?(we&mn)==mn?(u.clip(Ye),Ve&&u.clip(Ve),wt(X,fe),cn(x,J,S)):we&fu?(wt(X,fe),u.clip(Ye),cn(x,J,S)):we&kr&&(u.save(),u.clip(Ye),Ve&&u.clip(Ve),wt(X,fe),u.restore(),cn(x,J,S)):(wt(X,fe),cn(x,J,S)),(Ie||He||Ye)&&u.restore()}function cn(x,S,I){I>0&&(S instanceof Map?S.forEach((U,X)=>{u.strokeStyle=Sr=X,u.stroke(U)}):S!=null&&x&&u.stroke(S))}function wt(x,S){S instanceof Map?S.forEach((I,U)=>{u.fillStyle=Rs=U,u.fill(I)}):S!=null&&x&&u.fill(S)}function rs(x,S,I,U){let X=C[x],J;if(U<=0)J=[0,0];else{let fe=X._space=X.space(n,x,S,I,U),we=X._incrs=X.incrs(n,x,S,I,U,fe);J=gy(S,I,we,U,fe)}return X._found=J}function hn(x,S,I,U,X,J,fe,we,Ie,He){let Ve=fe%2/2;M==1&&u.translate(Ve,Ve),Ne(we,fe,Ie,He,we),u.beginPath();let Ye,mt,Pt,Et,St=X+(U==0||U==3?-J:J);I==0?(mt=X,Et=St):(Ye=X,Pt=St);for(let ct=0;ct<x.length;ct++)S[ct]!=null&&(I==0?Ye=Pt=x[ct]:mt=Et=x[ct],u.moveTo(Ye,mt),u.lineTo(Pt,Et));u.stroke(),M==1&&u.translate(-Ve,-Ve)}function Tr(x){let S=!0;return C.forEach((I,U)=>{if(!I.show)return;let X=v[I.scale];if(X.min==null){I._show&&(S=!1,I._show=!1,_t(!1));return}else I._show||(S=!1,I._show=!0,_t(!1));let J=I.side,fe=J%2,{min:we,max:Ie}=X,[He,Ve]=rs(U,we,Ie,fe==0?P:ue);if(Ve==0)return;let Ye=X.distr==2,mt=I._splits=I.splits(n,U,we,Ie,He,Ve,Ye),Pt=X.distr==2?mt.map(it=>Qn[it]):mt,Et=X.distr==2?Qn[mt[1]]-Qn[mt[0]]:He,St=I._values=I.values(n,I.filter(n,Pt,U,Ve,Et),U,Ve,Et);I._rotate=J==2?I.rotate(n,St,U,Ve):0;let ct=I._size;I._size=xi(I.size(n,St,U,x)),ct!=null&&I._size!=ct&&(S=!1)}),S}function Hi(x){let S=!0;return No.forEach((I,U)=>{let X=I(n,U,zi,x);X!=Si[U]&&(S=!1),Si[U]=X}),S}function os(){for(let x=0;x<C.length;x++){let S=C[x];if(!S.show||!S._show)continue;let I=S.side,U=I%2,X,J,fe=S.stroke(n,x),we=I==0||I==3?-1:1,[Ie,He]=S._found;if(S.label!=null){let kn=S.labelGap*we,ni=gn((S._lpos+kn)*It);Be(S.labelFont[0],fe,"center",I==2?"top":Wf),u.save(),U==1?(X=J=0,u.translate(ni,gn(y+se/2)),u.rotate((I==3?-il:il)/2)):(X=gn(A+z/2),J=ni);let Qs=Dp(S.label)?S.label(n,x,Ie,He):S.label;u.fillText(Qs,X,J),u.restore()}if(He==0)continue;let Ve=v[S.scale],Ye=U==0?z:se,mt=U==0?A:y,Pt=S._splits,Et=Ve.distr==2?Pt.map(kn=>Qn[kn]):Pt,St=Ve.distr==2?Qn[Pt[1]]-Qn[Pt[0]]:Ie,ct=S.ticks,it=S.border,Zt=ct.show?ct.size:0,rn=gn(Zt*It),An=gn((S.alignTo==2?S._size-Zt-S.gap:S.gap)*It),Ht=S._rotate*-il/180,on=m(S._pos*It),ei=(rn+An)*we,Bn=on+ei;J=U==0?Bn:0,X=U==1?Bn:0;let mi=S.font[0],wi=S.align==1?Dr:S.align==2?Qh:Ht>0?Dr:Ht<0?Qh:U==0?"center":I==3?Qh:Dr,Xi=Ht||U==1?"middle":I==2?"top":Wf;Be(mi,fe,wi,Xi);let ti=S.font[1]*S.lineGap,gi=Pt.map(kn=>m(a(kn,Ve,Ye,mt))),Ti=S._values;for(let kn=0;kn<Ti.length;kn++){let ni=Ti[kn];if(ni!=null){U==0?X=gi[kn]:J=gi[kn],ni=""+ni;let Qs=ni.indexOf(`
`)==-1?[ni]:ni.split(/\n/gm);for(let zn=0;zn<Qs.length;zn++){let Hf=Qs[zn];Ht?(u.save(),u.translate(X,J+zn*ti),u.rotate(Ht),u.fillText(Hf,0,0),u.restore()):u.fillText(Hf,X,J+zn*ti)}}}ct.show&&hn(gi,ct.filter(n,Et,x,He,St),U,I,on,rn,Wt(ct.width*It,3),ct.stroke(n,x),ct.dash,ct.cap);let qi=S.grid;qi.show&&hn(gi,qi.filter(n,Et,x,He,St),U,U==0?2:1,U==0?y:A,U==0?se:z,Wt(qi.width*It,3),qi.stroke(n,x),qi.dash,qi.cap),it.show&&hn([on],[1],U==0?1:0,U==0?1:2,U==1?y:A,U==1?se:z,Wt(it.width*It,3),it.stroke(n,x),it.dash,it.cap)}Tn("drawAxes")}function _t(x){b.forEach((S,I)=>{I>0&&(S._paths=null,x&&(s==1?(S.min=null,S.max=null):S.facets.forEach(U=>{U.min=null,U.max=null})))})}let sn=!1,Fn=!1,kt=[];function un(){Fn=!1;for(let x=0;x<kt.length;x++)Tn(...kt[x]);kt.length=0}function Dn(){sn||(cx(wf),sn=!0)}function Ka(x,S=!1){sn=!0,Fn=S,x(n),wf(),S&&kt.length>0&&queueMicrotask(un)}n.batch=Ka;function wf(){if(Q&&(vt(),Q=!1),ve&&(Pe(),ve=!1),me){if(Jt(f,Dr,ze),Jt(f,"top",Ue),Jt(f,Ho,P),Jt(f,Vo,ue),Jt(g,Dr,ze),Jt(g,"top",Ue),Jt(g,Ho,P),Jt(g,Vo,ue),Jt(d,Ho,_e),Jt(d,Vo,$e),h.width=gn(_e*It),h.height=gn($e*It),C.forEach(({_el:x,_show:S,_size:I,_pos:U,side:X})=>{if(x!=null)if(S){let J=X===3||X===0?I:0,fe=X%2==1;Jt(x,fe?"left":"top",U-J),Jt(x,fe?"width":"height",I),Jt(x,fe?"top":"left",fe?Ue:ze),Jt(x,fe?"height":"width",fe?ue:P),lu(x,nr)}else ii(x,nr)}),Sr=Rs=wr=G=ne=$=Z=De=w=null,Oe=1,ko(!0),ze!=ye||Ue!=qe||P!=Te||ue!=Ge){_t(!1);let x=P/Te,S=ue/Ge;if(ge&&!te&&he.left>=0){he.left*=x,he.top*=S,Ar&&Yi(Ar,gn(he.left),0,P,ue),Er&&Yi(Er,0,gn(he.top),P,ue);for(let I=0;I<lt.length;I++){let U=lt[I];U!=null&&(Gt[I]*=x,Ln[I]*=S,Yi(U,xi(Gt[I]),xi(Ln[I]),P,ue))}}if($t.show&&!re&&$t.left>=0&&$t.width>0){$t.left*=x,$t.width*=x,$t.top*=S,$t.height*=S;for(let I in Zh)Jt(Pr,I,$t[I])}ye=ze,qe=Ue,Te=P,Ge=ue}Tn("setSize"),me=!1}_e>0&&$e>0&&(u.clearRect(0,0,h.width,h.height),Tn("drawClear"),T.forEach(x=>x()),Tn("draw")),$t.show&&re&&(ja($t),re=!1),ge&&te&&(js(null,!0,!1),te=!1),pe.show&&pe.live&&be&&(Yh(),be=!1),l||(l=!0,n.status=1,Tn("ready")),Cs=!1,sn=!1}n.redraw=(x,S)=>{ve=S||!1,x!==!1?Is(E,D.min,D.max):Dn()};function Wh(x,S){let I=v[x];if(I.from==null){if(nn==0){let U=I.range(n,S.min,S.max,x);S.min=U[0],S.max=U[1]}if(S.min>S.max){let U=S.min;S.min=S.max,S.max=U}if(nn>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;x==E&&I.distr==2&&nn>0&&(S.min=Ei(S.min,e[0]),S.max=Ei(S.max,e[0]),S.min==S.max&&S.max++),H[x]=S,Q=!0,Dn()}}n.setScale=Wh;let Xh,qh,Ar,Er,Tf,Af,Cr,Rr,Ef,Cf,Yt,jt,Ps=!1,Pn=he.drag,Sn=Pn.x,wn=Pn.y;ge&&(he.x&&(Xh=_i(D_,g)),he.y&&(qh=_i(N_,g)),D.ori==0?(Ar=Xh,Er=qh):(Ar=qh,Er=Xh),Yt=he.left,jt=he.top);let $t=n.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Pr=$t.show?_i(L_,$t.over?g:f):null;function ja(x,S){if($t.show){for(let I in x)$t[I]=x[I],I in Zh&&Jt(Pr,I,x[I]);S!==!1&&Tn("setSelect")}}n.setSelect=ja;function d_(x){if(b[x].show)ee&&lu(ut[x],nr);else if(ee&&ii(ut[x],nr),ge){let I=Ce?lt[0]:lt[x];I!=null&&Yi(I,-10,-10,P,ue)}}function Is(x,S,I){Wh(x,{min:S,max:I})}function Vi(x,S,I,U){S.focus!=null&&__(x),S.show!=null&&b.forEach((X,J)=>{J>0&&(x==J||x==null)&&(X.show=S.show,d_(J),s==2?(Is(X.facets[0].scale,null,null),Is(X.facets[1].scale,null,null)):Is(X.scale,null,null),Dn())}),I!==!1&&Tn("setSeries",x,S),U&&zo("setSeries",n,x,S)}n.setSeries=Vi;function f_(x,S){fn(R[x],S)}function p_(x,S){x.fill=Tt(x.fill||null),x.dir=Ct(x.dir,-1),S=S??R.length,R.splice(S,0,x)}function m_(x){x==null?R.length=0:R.splice(x,1)}n.addBand=p_,n.setBand=f_,n.delBand=m_;function g_(x,S){b[x].alpha=S,ge&&lt[x]!=null&&(lt[x].style.opacity=S),ee&&ut[x]&&(ut[x].style.opacity=S)}let as,Ls,Ks,Ir={focus:!0};function __(x){if(x!=Ks){let S=x==null,I=Fe.alpha!=1;b.forEach((U,X)=>{if(s==1||X>0){let J=S||X==0||X==x;U._focus=S?null:J,I&&g_(X,J?1:Fe.alpha)}}),Ks=x,I&&Dn()}}ee&&tt&&xe($f,Le,x=>{he._lock||(st(x),Ks!=null&&Vi(null,Ir,!0,dn.setSeries))});function Wi(x,S,I){let U=v[S];I&&(x=x/It-(U.ori==1?Ue:ze));let X=P;U.ori==1&&(X=ue,x=X-x),U.dir==-1&&(x=X-x);let J=U._min,fe=U._max,we=x/X,Ie=J+(fe-J)*we,He=U.distr;return He==3?Or(10,Ie):He==4?K_(Ie,U.asinh):He==100?U.bwd(Ie):Ie}function x_(x,S){let I=Wi(x,E,S);return Ei(I,e[0],an,ln)}n.valToIdx=x=>Ei(x,e[0]),n.posToIdx=x_,n.posToVal=Wi,n.valToPos=(x,S,I)=>v[S].ori==0?r(x,v[S],I?z:P,I?A:0):o(x,v[S],I?se:ue,I?y:0),n.setCursor=(x,S,I)=>{Yt=x.left,jt=x.top,js(null,S,I)};function Rf(x,S){Jt(Pr,Dr,$t.left=x),Jt(Pr,Ho,$t.width=S)}function Pf(x,S){Jt(Pr,"top",$t.top=x),Jt(Pr,Vo,$t.height=S)}let Fo=D.ori==0?Rf:Pf,Bo=D.ori==1?Rf:Pf;function y_(){if(ee&&pe.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&pt)continue;let S=pe.values[x],I=0;for(let U in S)Je[x][I++].firstChild.nodeValue=S[U]}}function Yh(x,S){if(x!=null&&(x.idxs?x.idxs.forEach((I,U)=>{ie[U]=I}):tx(x.idx)||ie.fill(x.idx),pe.idx=ie[0]),ee&&pe.live){for(let I=0;I<b.length;I++)(I>0||s==1&&!pt)&&v_(I,ie[I]);y_()}be=!1,S!==!1&&Tn("setLegend")}n.setLegend=Yh;function v_(x,S){let I=b[x],U=x==0&&k==2?Qn:e[x],X;pt?X=I.values(n,x,S)??ot:(X=I.value(n,S==null?null:U[S],x,S),X=X==null?ot:{_:X}),pe.values[x]=X}function js(x,S,I){Ef=Yt,Cf=jt,[Yt,jt]=he.move(n,Yt,jt),he.left=Yt,he.top=jt,ge&&(Ar&&Yi(Ar,gn(Yt),0,P,ue),Er&&Yi(Er,0,gn(jt),P,ue));let U,X=an>ln;as=Vt,Ls=null;let J=D.ori==0?P:ue,fe=D.ori==1?P:ue;if(Yt<0||nn==0||X){U=he.idx=null;for(let we=0;we<b.length;we++){let Ie=lt[we];Ie!=null&&Yi(Ie,-10,-10,P,ue)}tt&&Vi(null,Ir,!0,x==null&&dn.setSeries),pe.live&&(ie.fill(U),be=!0)}else{let we,Ie,He;s==1&&(we=D.ori==0?Yt:jt,Ie=Wi(we,E),U=he.idx=Ei(Ie,e[0],an,ln),He=W(e[0][U],D,J,0));let Ve=-10,Ye=-10,mt=0,Pt=0,Et=!0,St="",ct="";for(let it=s==2?1:0;it<b.length;it++){let Zt=b[it],rn=ie[it],An=rn==null?null:s==1?e[it][rn]:e[it][1][rn],Ht=he.dataIdx(n,it,U,Ie),on=Ht==null?null:s==1?e[it][Ht]:e[it][1][Ht];if(be=be||on!=An||Ht!=rn,ie[it]=Ht,it>0&&Zt.show){let ei=Ht==null?-10:Ht==U?He:W(s==1?e[0][Ht]:e[it][0][Ht],D,J,0),Bn=on==null?-10:L(on,s==1?v[Zt.scale]:v[Zt.facets[1].scale],fe,0);if(tt&&on!=null){let mi=D.ori==1?Yt:jt,wi=_n(Fe.dist(n,it,Ht,Bn,mi));if(wi<as){let Xi=Fe.bias;if(Xi!=0){let ti=Wi(mi,Zt.scale),gi=on>=0?1:-1,Ti=ti>=0?1:-1;Ti==gi&&(Ti==1?Xi==1?on>=ti:on<=ti:Xi==1?on<=ti:on>=ti)&&(as=wi,Ls=it)}else as=wi,Ls=it}}if(be||Ce){let mi,wi;D.ori==0?(mi=ei,wi=Bn):(mi=Bn,wi=ei);let Xi,ti,gi,Ti,qi,kn,ni=!0,Qs=le.bbox;if(Qs!=null){ni=!1;let zn=Qs(n,it);gi=zn.left,Ti=zn.top,Xi=zn.width,ti=zn.height}else gi=mi,Ti=wi,Xi=ti=le.size(n,it);if(kn=le.fill(n,it),qi=le.stroke(n,it),Ce)it==Ls&&as<=Fe.prox&&(Ve=gi,Ye=Ti,mt=Xi,Pt=ti,Et=ni,St=kn,ct=qi);else{let zn=lt[it];zn!=null&&(Gt[it]=gi,Ln[it]=Ti,tp(zn,Xi,ti,ni),Qf(zn,kn,qi),Yi(zn,xi(gi),xi(Ti),P,ue))}}}}if(Ce){let it=Fe.prox,Zt=Ks==null?as<=it:as>it||Ls!=Ks;if(be||Zt){let rn=lt[0];rn!=null&&(Gt[0]=Ve,Ln[0]=Ye,tp(rn,mt,Pt,Et),Qf(rn,St,ct),Yi(rn,xi(Ve),xi(Ye),P,ue))}}}if($t.show&&Ps)if(x!=null){let[we,Ie]=dn.scales,[He,Ve]=dn.match,[Ye,mt]=x.cursor.sync.scales,Pt=x.cursor.drag;if(Sn=Pt._x,wn=Pt._y,Sn||wn){let{left:Et,top:St,width:ct,height:it}=x.select,Zt=x.scales[Ye].ori,rn=x.posToVal,An,Ht,on,ei,Bn,mi=we!=null&&He(we,Ye),wi=Ie!=null&&Ve(Ie,mt);mi&&Sn?(Zt==0?(An=Et,Ht=ct):(An=St,Ht=it),on=v[we],ei=W(rn(An,Ye),on,J,0),Bn=W(rn(An+Ht,Ye),on,J,0),Fo(Ci(ei,Bn),_n(Bn-ei))):Fo(0,J),wi&&wn?(Zt==1?(An=Et,Ht=ct):(An=St,Ht=it),on=v[Ie],ei=L(rn(An,mt),on,fe,0),Bn=L(rn(An+Ht,mt),on,fe,0),Bo(Ci(ei,Bn),_n(Bn-ei))):Bo(0,fe)}else Jh()}else{let we=_n(Ef-Tf),Ie=_n(Cf-Af);if(D.ori==1){let mt=we;we=Ie,Ie=mt}Sn=Pn.x&&we>=Pn.dist,wn=Pn.y&&Ie>=Pn.dist;let He=Pn.uni;He!=null?Sn&&wn&&(Sn=we>=He,wn=Ie>=He,!Sn&&!wn&&(Ie>we?wn=!0:Sn=!0)):Pn.x&&Pn.y&&(Sn||wn)&&(Sn=wn=!0);let Ve,Ye;Sn&&(D.ori==0?(Ve=Cr,Ye=Yt):(Ve=Rr,Ye=jt),Fo(Ci(Ve,Ye),_n(Ye-Ve)),wn||Bo(0,fe)),wn&&(D.ori==1?(Ve=Cr,Ye=Yt):(Ve=Rr,Ye=jt),Bo(Ci(Ve,Ye),_n(Ye-Ve)),Sn||Fo(0,J)),!Sn&&!wn&&(Fo(0,0),Bo(0,0))}if(Pn._x=Sn,Pn._y=wn,x==null){if(I){if(Gf!=null){let[we,Ie]=dn.scales;dn.values[0]=we!=null?Wi(D.ori==0?Yt:jt,we):null,dn.values[1]=Ie!=null?Wi(D.ori==1?Yt:jt,Ie):null}zo(eu,n,Yt,jt,P,ue,U)}if(tt){let we=I&&dn.setSeries,Ie=Fe.prox;Ks==null?as<=Ie&&Vi(Ls,Ir,!0,we):as>Ie?Vi(null,Ir,!0,we):Ls!=Ks&&Vi(Ls,Ir,!0,we)}}be&&(pe.idx=U,Yh()),S!==!1&&Tn("setCursor")}let Ds=null;Object.defineProperty(n,"rect",{get(){return Ds==null&&ko(!1),Ds}});function ko(x=!1){x?Ds=null:(Ds=g.getBoundingClientRect(),Tn("syncRect",Ds))}function If(x,S,I,U,X,J,fe){he._lock||Ps&&x!=null&&x.movementX==0&&x.movementY==0||($h(x,S,I,U,X,J,fe,!1,x!=null),x!=null?js(null,!0,!0):js(S,!0,!1))}function $h(x,S,I,U,X,J,fe,we,Ie){if(Ds==null&&ko(!1),st(x),x!=null)I=x.clientX-Ds.left,U=x.clientY-Ds.top;else{if(I<0||U<0){Yt=-10,jt=-10;return}let[He,Ve]=dn.scales,Ye=S.cursor.sync,[mt,Pt]=Ye.values,[Et,St]=Ye.scales,[ct,it]=dn.match,Zt=S.axes[0].side%2==1,rn=D.ori==0?P:ue,An=D.ori==1?P:ue,Ht=Zt?J:X,on=Zt?X:J,ei=Zt?U:I,Bn=Zt?I:U;if(Et!=null?I=ct(He,Et)?a(mt,v[He],rn,0):-10:I=rn*(ei/Ht),St!=null?U=it(Ve,St)?a(Pt,v[Ve],An,0):-10:U=An*(Bn/on),D.ori==1){let mi=I;I=U,U=mi}}Ie&&(S==null||S.cursor.event.type==eu)&&((I<=1||I>=P-1)&&(I=er(I,P)),(U<=1||U>=ue-1)&&(U=er(U,ue))),we?(Tf=I,Af=U,[Cr,Rr]=he.move(n,I,U)):(Yt=I,jt=U)}let Zh={width:0,height:0,left:0,top:0};function Jh(){ja(Zh,!1)}let Lf,Df,Nf,Uf;function Of(x,S,I,U,X,J,fe){Ps=!0,Sn=wn=Pn._x=Pn._y=!1,$h(x,S,I,U,X,J,fe,!0,!1),x!=null&&(xe(tu,ou,Ff,!1),zo(qf,n,Cr,Rr,P,ue,null));let{left:we,top:Ie,width:He,height:Ve}=$t;Lf=we,Df=Ie,Nf=He,Uf=Ve}function Ff(x,S,I,U,X,J,fe){Ps=Pn._x=Pn._y=!1,$h(x,S,I,U,X,J,fe,!1,!0);let{left:we,top:Ie,width:He,height:Ve}=$t,Ye=He>0||Ve>0,mt=Lf!=we||Df!=Ie||Nf!=He||Uf!=Ve;if(Ye&&mt&&ja($t),Pn.setScale&&Ye&&mt){let Pt=we,Et=He,St=Ie,ct=Ve;if(D.ori==1&&(Pt=Ie,Et=Ve,St=we,ct=He),Sn&&Is(E,Wi(Pt,E),Wi(Pt+Et,E)),wn)for(let it in v){let Zt=v[it];it!=E&&Zt.from==null&&Zt.min!=Vt&&Is(it,Wi(St+ct,it),Wi(St,it))}Jh()}else he.lock&&(he._lock=!he._lock,js(S,!0,x!=null));x!=null&&(Se(tu,ou),zo(tu,n,Yt,jt,P,ue,null))}function b_(x,S,I,U,X,J,fe){if(he._lock)return;st(x);let we=Ps;if(Ps){let Ie=!0,He=!0,Ve=10,Ye,mt;D.ori==0?(Ye=Sn,mt=wn):(Ye=wn,mt=Sn),Ye&&mt&&(Ie=Yt<=Ve||Yt>=P-Ve,He=jt<=Ve||jt>=ue-Ve),Ye&&Ie&&(Yt=Yt<Cr?0:P),mt&&He&&(jt=jt<Rr?0:ue),js(null,!0,!0),Ps=!1}Yt=-10,jt=-10,ie.fill(null),js(null,!0,!0),we&&(Ps=we)}function Bf(x,S,I,U,X,J,fe){he._lock||(st(x),Oo(),Jh(),x!=null&&zo(Zf,n,Yt,jt,P,ue,null))}function kf(){C.forEach(_y),O(n.width,n.height,!0)}ir(sl,Ur,kf);let Lr={};Lr.mousedown=Of,Lr.mousemove=If,Lr.mouseup=Ff,Lr.dblclick=Bf,Lr.setSeries=(x,S,I,U)=>{let X=dn.match[2];I=X(n,S,I),I!=-1&&Vi(I,U,!0,!1)},ge&&(xe(qf,g,Of),xe(eu,g,If),xe(Yf,g,x=>{st(x),ko(!1)}),xe($f,g,b_),xe(Zf,g,Bf),pu.add(n),n.syncRect=ko);let Qa=n.hooks=i.hooks||{};function Tn(x,S,I){Fn?kt.push([x,S,I]):x in Qa&&Qa[x].forEach(U=>{U.call(null,n,S,I)})}(i.plugins||[]).forEach(x=>{for(let S in x.hooks)Qa[S]=(Qa[S]||[]).concat(x.hooks[S])});let zf=(x,S,I)=>I,dn=fn({key:null,setSeries:!1,filters:{pub:op,sub:op},scales:[E,b[1]?b[1].scale:null],match:[ap,ap,zf],values:[null,null]},he.sync);dn.match.length==2&&dn.match.push(zf),he.sync=dn;let Gf=dn.key,Kh=im(Gf);function zo(x,S,I,U,X,J,fe){dn.filters.pub(x,S,I,U,X,J,fe)&&Kh.pub(x,S,I,U,X,J,fe)}Kh.sub(n);function M_(x,S,I,U,X,J,fe){dn.filters.sub(x,S,I,U,X,J,fe)&&Lr[x](null,S,I,U,X,J,fe)}n.pub=M_;function S_(){Kh.unsub(n),pu.delete(n),de.clear(),cu(sl,Ur,kf),c.remove(),Le?.remove(),Tn("destroy")}n.destroy=S_;function jh(){Tn("init",i,e),Uo(e||i.data,!1),H[E]?Wh(E,H[E]):Oo(),re=$t.show&&($t.width>0||$t.height>0),te=be=!0,O(i.width,i.height)}return b.forEach(Mr),C.forEach(is),t?t instanceof HTMLElement?(t.appendChild(c),jh()):t(n,jh):jh(),n}xn.assign=fn;xn.fmtNum=bu;xn.rangeNum=rl;xn.rangeLog=ll;xn.rangeAsinh=yu;xn.orient=rr;xn.pxRatio=It;xn.join=lx;xn.fmtDate=Su,xn.tzDate=yx;xn.sync=im;{xn.addGap=ty,xn.clipGaps=ul;let i=xn.paths={points:cm};i.linear=um,i.stepped=sy,i.bars=ry,i.spline=ay}function $i(i,e){if(!Number.isFinite(i))return"\u2013";let t=Number(i.toPrecision(e)),n=Math.abs(t);return n!==0&&(n>=1e6||n<1e-4)?gm(t.toExponential()):`${t}`}function gm(i){return i.replace("e+","e")}function _m(i,e){let t=Math.max(...i.map(Math.abs));if(t>=1e6||e<1e-4){let r=Math.max(Math.ceil(Math.log10(t/e)-1e-9),0);return i.map(o=>o===0?"0":gm(o.toExponential(Math.min(r,15)).replace(/\.?0+e/,"e")))}let n=0;for(;Math.abs(e*10**n-Math.round(e*10**n))>1e-6;)++n;let s={minimumFractionDigits:n,maximumFractionDigits:n};return i.map(r=>(r===0?0:r).toLocaleString("en-US",s))}function Vr(i){let e=10**Math.floor(Math.log10(i));return([1,2,5].find(t=>t*e>=i*(1-1e-9))??10)*e}function ml(i,e,t){let n=i.filter(({kind:s})=>s!=="tick").map(s=>[xm(s.time,e,t,400),s]);return[...new Map(n.reverse()).values()].reverse()}var mm=100;function gl(i,e,t){let n=new Array(mm).fill(0);for(let{time:r,kind:o}of i)o==="tick"&&++n[xm(r,e,t,mm)];let s=Math.max(...n);return s>0?n.map(r=>r/s):[]}function xm(i,e,t,n){return Math.min(Math.max(Math.floor(n*(i-e)/(t-e||1)),0),n-1)}var xy="alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi chi psi omega",yy="\u03B1\u03B2\u03B3\u03B4\u03B5\u03B6\u03B7\u03B8\u03B9\u03BA\u03BB\u03BC\u03BD\u03BE\u03BF\u03C0\u03C1\u03C3\u03C4\u03C5\u03C6\u03C7\u03C8\u03C9";function ym(i){let e=xy.split(" ");return i.replace(/[a-z]+/g,t=>e.includes(t)?yy[e.indexOf(t)]:t)}var $o=["#2563eb","#dc2626","#16a34a","#d97706","#7c3aed","#0891b2","#db2777","#65a30d"],_l=600;function Zo(i){let e=getComputedStyle(document.documentElement),t=e.getPropertyValue("--ink-soft").trim(),n={stroke:e.getPropertyValue("--line").trim(),width:1};return{label:i,stroke:t,grid:n,ticks:n,labelSize:18,font:"11px system-ui",labelFont:"11px system-ui",values:(s,r,o,a,l)=>_m(r,l)}}function xl(i){let e=(t,n)=>Math.max(64,36+6.5*Math.max(0,...(n??[]).map(s=>s.length)));return{...Zo(i),size:e}}function yl(i,e){let t=Math.max(Math.abs(i),Math.abs(e)),n=Math.max(.06*(e-i),e-i<1e-6*t?.001*t:0,1e-12);return[i-n,e+n]}function et(i,e={},...t){let n=Object.assign(document.createElement(i),e);return n.append(...t),n}function Xt(i){let e=document.getElementById(i);if(e===null)throw new Error(`the page has no #${i}`);return e}var vy=20,vl=class{constructor(e,t,n){this.head=e;this.motion=t;let s=e.columns.slice(0,e.scene.first),r=s.filter(l=>l.kind==="coordinate").length,o=r>0?1:Math.min(1,s.length-1),a=r>0?1+r:s.length-1;this.choices=[this.choice("to the right",s,o),this.choice("upward",s,a)],!(s.length<2)&&(n.append(et("p",{className:"portrait"},this.choices[1]," over ",this.choices[0]),this.board),this.rebuild())}head;motion;plot=null;board=et("div");dot=et("i",{className:"dot"});choices;choice(e,t,n){let s=et("select",{ariaLabel:`Column of the portrait, ${e}`});return t.forEach(({name:r},o)=>s.append(new Option(r,`${o}`,o===n,o===n))),s.onchange=()=>this.rebuild(),s}values(e){let t=Number(this.choices[e].value),{scale:n,shift:s}=this.head.columns[t].display;return this.motion.column(t).map(r=>r*n+s)}get data(){return[null,[this.values(0),this.values(1)]]}rebuild(){this.plot?.destroy();let[e,t]=this.choices.map(s=>{let{name:r,display:o}=this.head.columns[Number(s.value)],a=`[${o.unit||"1"}]`;return r.length<=vy?`${r} ${a}`:a}),n=s=>()=>{let[r,o]=[1/0,-1/0];for(let a of this.values(s))Number.isFinite(a)&&([r,o]=[Math.min(r,a),Math.max(o,a)]);return o>r||([r,o]=[(Number.isFinite(r)?r:0)-1,(Number.isFinite(o)?o:0)+1]),yl(r,o)};this.plot=new xn({...this.size(),mode:2,scales:{x:{time:!1,range:n(0)},y:{range:n(1)}},axes:[{...Zo(e),size:40},xl(t)],cursor:{show:!1},legend:{show:!1},series:[{},{facets:[{scale:"x",auto:!0},{scale:"y",auto:!0}],paths:by}]},this.data,this.board),this.plot.over.append(this.dot)}show(e){this.motion=e,this.plot?.setData(this.data)}point(e){if(this.plot===null||this.motion.count===0||this.board.clientWidth===0)return;let t=this.motion.rowAt(e),[n,s]=this.choices.map(r=>{let o=Number(r.value),{scale:a,shift:l}=this.head.columns[o].display;return this.motion.at(t,o)*a+l});this.dot.style.left=`${this.plot.valToPos(n,"x")}px`,this.dot.style.top=`${this.plot.valToPos(s,"y")}px`}size(){return{width:Math.max(this.board.clientWidth||_l,240),height:240}}resize(){this.plot?.setSize(this.size())}};function by(i){let[e,t]=i.data[1],{ctx:n}=i;return n.save(),n.beginPath(),n.rect(i.bbox.left,i.bbox.top,i.bbox.width,i.bbox.height),n.clip(),n.beginPath(),e.forEach((s,r)=>n.lineTo(i.valToPos(s,"x",!0),i.valToPos(t[r],"y",!0))),n.strokeStyle=$o[0],n.lineWidth=1.5*window.devicePixelRatio,n.stroke(),n.restore(),null}var vm=4,bl=class{constructor(e,t,n,s){this.head=e;this.sought=s;this.motion=t,this.events=e.events;let r=this.columns(),o=r.filter(({column:c})=>e.curves.includes(c.name)),a=o.length>0?o:r.filter(({column:c})=>c.kind==="coordinate").slice(0,vm);this.chosen=new Set((a.length>0?a:r.slice(0,vm)).map(({index:c})=>c));let l=r.map(({column:c,index:h})=>this.choice(c,h));this.board=et("div"),n.append(et("details",{},et("summary",{textContent:"Choose curves"}),...l),this.board),this.portrait=new vl(e,t,n),new ResizeObserver(([{contentRect:c}])=>{this.seen=c.width>0,this.resize()}).observe(n),window.addEventListener("beforeprint",()=>{this.seen=!0,this.point(this.time)}),this.rebuild()}head;sought;charts=[];chosen;board;portrait;motion;events;family=[];time=0;seen=!1;columns(){return this.head.columns.map((e,t)=>({column:e,index:t})).slice(1,this.head.scene.first)}choice(e,t){let n=et("input",{type:"checkbox",checked:this.chosen.has(t)});n.onchange=()=>{n.checked?this.chosen.add(t):this.chosen.delete(t),this.rebuild()};let s=e.display.unit?` [${e.display.unit}]`:"";return et("label",{className:"choice",title:e.doc??""},n,`${e.name}${s}`)}rebuild(){for(let s of this.charts)s.plot.destroy();this.charts.length=0;let e=new Map;for(let s of[...this.chosen].sort((r,o)=>r-o)){let r=this.head.columns[s].display.unit;e.set(r,[...e.get(r)??[],s])}for(let[s,r]of e)this.overTime(s,r);let t=this.head.scene.first+this.head.scene.count,n={name:"energy",display:{unit:"J",scale:1,shift:0}};this.add("J",[n.name],s=>[s.column(0),s.column(t)]),this.point(this.time)}value(e,t){let{scale:n,shift:s}=this.head.columns[t].display;return e.column(t).map(r=>r*n+s)}overTime(e,t){let n=t.map(r=>this.head.columns[r].name),s=r=>t.map(o=>this.value(r,o));this.add(e,n,r=>[r.column(0),...s(r)])}underlay(e,t){let{ctx:n,bbox:s}=e;n.save(),n.beginPath(),n.rect(s.left,s.top,s.width,s.height),n.clip(),n.lineWidth=window.devicePixelRatio,n.strokeStyle="rgb(148 163 184 / 45%)";for(let c of this.family){let[h,...u]=t(c);for(let d of u)n.beginPath(),h.forEach((f,g)=>n.lineTo(e.valToPos(f,"x",!0),e.valToPos(d[g],"y",!0))),n.stroke()}let{min:r=0,max:o=1}=e.scales.x,a=7*window.devicePixelRatio,l=gl(this.events,r,o);n.fillStyle="#64748b",l.forEach((c,h)=>{n.globalAlpha=.5*c,n.fillRect(s.left+s.width*h/l.length,s.top+s.height-a,s.width/l.length,a)}),n.globalAlpha=1,n.strokeStyle="#dc2626";for(let{time:c}of ml(this.events,r,o)){let h=e.valToPos(c,"x",!0);n.beginPath(),n.moveTo(h,s.top+s.height),n.lineTo(h,s.top+s.height-a),n.stroke()}n.restore()}range(e,t,n){let[s,r]=[t??0,n??1];for(let o of this.family)for(let a of e(o).slice(1))for(let l of a)Number.isFinite(l)&&([s,r]=[Math.min(s,l),Math.max(r,l)]);return yl(s,r)}add(e,t,n){let s=new xn({...this.size(),scales:{x:{time:!1},y:{range:(r,o,a)=>this.range(n,o,a)}},axes:[{...Zo("t [s]"),size:40},xl(e===""?"":`[${e}]`)],cursor:{sync:{key:"time"},drag:{x:!1,y:!1}},series:[{label:"t",value:(r,o)=>bm(o,"s")},...t.map((r,o)=>({label:r,stroke:$o[o%$o.length],width:1.5,value:(a,l)=>bm(l,e)}))],hooks:{ready:[r=>r.over.addEventListener("click",()=>this.seek(r))],drawAxes:[r=>this.underlay(r,n)]}},n(this.motion),this.board);this.charts.push({plot:s,data:n})}seek(e){e.cursor.left!==void 0&&e.cursor.left>=0&&this.sought(e.posToVal(e.cursor.left,"x"))}show(e,t){this.motion=e,this.events=t;for(let{plot:n,data:s}of this.charts)n.setData(s(e));this.portrait.show(e)}behind(e){this.family=e,this.rebuild()}point(e){if(this.time=e,!!this.seen){for(let{plot:t}of this.charts)t.setCursor({left:t.valToPos(e,"x"),top:-10},!1);this.portrait.point(e)}}size(){return{width:Math.max(this.board.clientWidth||_l,240),height:190}}resize(){for(let{plot:e}of this.charts)e.setSize(this.size());this.portrait.resize(),queueMicrotask(()=>this.point(this.time))}};function bm(i,e){return i===null||!Number.isFinite(i)?"\u2013":`${$i(i,5)} ${e}`}function Wr(i,e){let t=document.createElement("a");t.href=URL.createObjectURL(i),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e3)}function Mm(i,e){i.toBlob(t=>t!==null&&Wr(t,`${e.name}.png`),"image/png")}function Sm(i,e){let t=e.columns.slice(0,e.scene.first),n=r=>/[",\n]/.test(r)?`"${r.replaceAll('"','""')}"`:r,s=[t.map(r=>n(r.name)).join(",")];for(let r=0;r<i.count;++r)s.push(t.map((o,a)=>i.at(r,a)).join(","));Wr(new Blob([`${s.join(`
`)}
`],{type:"text/csv"}),`${e.name}.csv`)}function wm(i,e){let t=[],n=new MediaRecorder(i.captureStream(60),{mimeType:"video/webm"});return n.ondataavailable=s=>t.push(s.data),n.onstop=()=>Wr(new Blob(t,{type:"video/webm"}),`${e.name}.webm`),n.start(),()=>n.stop()}var Pu=class{list=[];put(...e){for(let t of e)this.list.push(t)}word(e){this.put(e&255,e>>8)}text(e){for(let t of e)this.put(t.charCodeAt(0))}get all(){return Uint8Array.from(this.list)}},My=5;function Tm(i,e){return i[e]>>3<<10|i[e+1]>>3<<5|i[e+2]>>3}function Sy(i){let e=new Uint32Array(1<<3*My);for(let{data:o}of i)for(let a=0;a<o.length;a+=4)++e[Tm(o,a)];let t=o=>[10,5,0].map(a=>Math.round((o>>a&31)*255/31)),n=[...e.keys()].filter(o=>e[o]>0).sort((o,a)=>e[a]-e[o]),s=n.slice(0,256).map(t),r=new Uint8Array(e.length);for(let o of n){let a=t(o),l=s.map(c=>c.reduce((h,u,d)=>h+(u-a[d])**2,0));r[o]=l.indexOf(Math.min(...l))}return{colors:s,places:r}}function wy(i,e){let[t,n]=[256,257],s=new Map,[r,o,a,l]=[258,9,0,0],c=[],h=()=>{c.length>0&&e.put(c.length,...c),c=[]},u=f=>{for(a|=f<<l,l+=o;l>=8;)c.push(a&255),a>>=8,l-=8,c.length===255&&h()};e.put(8),u(t);let d=i[0];for(let f=1;f<i.length;++f){let g=d<<8|i[f],M=s.get(g);if(M!==void 0){d=M;continue}u(d),r<4096?(r===1<<o&&o<12&&++o,s.set(g,r++)):(u(t),s=new Map,[r,o]=[258,9]),d=i[f]}u(d),r===1<<o&&o<12&&++o,u(n),l>0&&c.push(a&255),h(),e.put(0)}function Am(i,e){let t=new Pu,{width:n,height:s}=i[0];t.text("GIF89a"),t.word(n),t.word(s),t.put(247,0,0);let{colors:r,places:o}=Sy(i);for(let a=0;a<256;++a)t.put(...r[a]??[0,0,0]);t.put(33,255,11),t.text("NETSCAPE2.0"),t.put(3,1,0,0,0);for(let{data:a}of i){t.put(33,249,4,0),t.word(Math.round(e/10)),t.put(0,0,44,0,0,0,0),t.word(n),t.word(s),t.put(0);let l=new Uint8Array(n*s);for(let c=0;c<l.length;++c)l[c]=o[Tm(a,4*c)];wy(l,t)}return t.put(59),new Blob([t.all],{type:"image/gif"})}function Ty(i,e){return i.columns.flatMap(({name:t,kind:n,unit:s},r)=>{let o=i.parameters.findIndex(a=>n==="coordinate"&&a.name===`${t}.start`);return o<0?[]:[{parameter:o,column:r,size:s==="m"?e:1}]})}function Em(i,e,t,n){let s=null,[r,o]=[0,0],a=null,l=Ty(i,e.length);t.addEventListener("pointerdown",c=>{s=n.ready()&&c.button===0&&l.length>0&&c.target===e.canvas?e.held(c.clientX,c.clientY):null,s!==null&&(c.stopPropagation(),[r,o,a]=[c.clientX,c.clientY,null],e.canvas.setPointerCapture(c.pointerId))},{capture:!0}),t.addEventListener("pointermove",c=>{if(s===null)return;if(a===null){if(Math.hypot(c.clientX-r,c.clientY-o)<3)return;n.begin(),a=e.facingPlace(r,o,s.point).place.sub(s.point)}let{place:h,across:u}=e.facingPlace(c.clientX,c.clientY,s.point);if(s.shape.kind!=="dial"){n.pull({parts:s.parts,goal:h.sub(a).toArray(),across:u.map(m=>m.toArray()),starts:l});return}let[d,f]=u.map(m=>h.clone().sub(s?.point??h).dot(m)),g=Math.atan2(-d,f),M=2*Math.PI;n.turn(`${s.shape.name}.start`,m=>g+M*Math.round((m-g)/M))});for(let c of["pointerup","pointercancel"])t.addEventListener(c,()=>s=null)}var Ay="0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;,=>?@^_`{|}~";function Iu(i){let e=new Uint8Array(128);for(let s=0;s<85;++s)e[Ay.charCodeAt(s)]=s;let t=i.trim(),n=new DataView(new ArrayBuffer(4*Math.ceil(t.length/5)));for(let s=0;s<t.length;s+=5){let r=0;for(let o=0;o<5;++o)r=r*85+(s+o<t.length?e[t.charCodeAt(s+o)]:84);n.setUint32(4*s/5,r)}return new Uint8Array(n.buffer,0,Math.floor(4*t.length/5))}async function Ml(i){let e=new Blob([Iu(i)]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}function Lu(i){return document.getElementById(i)?.textContent??""}function Cm(){return JSON.parse(Lu("head"))}function Xr(i){return Ml(Lu(i))}async function Rm(){document.fonts.add(await new FontFace("lagdsl Math",Iu(Lu("font"))).load())}function Sl(i,e,t){return(i.words[e]??`The run ended with status ${e}.`).replace(/\{(\w+)\}/g,(s,r)=>[...new Set(t.map(o=>i.blamed[r][o]))].join(", "))}var qr=class{constructor(e,t){this.width=e;this.values=t;this.count=Math.floor(t.length/e)}width;values;count;at(e,t){return this.values[e*this.width+t]}get last(){return this.count>0?this.at(this.count-1,0):0}rowAt(e){let t=0,n=this.count-1;for(;t<n;){let s=t+n+1>>1;this.at(s,0)<=e?t=s:n=s-1}return t}state(e,t){let n=this.rowAt(e),s=Math.min(n+1,this.count-1),r=this.at(s,0)-this.at(n,0),o=r>0?Math.min(Math.max((e-this.at(n,0))/r,0),1):0;for(let a=0;a<this.width;++a){let l=this.at(n,a);t[a]=l+o*(this.at(s,a)-l)}return t}largest(e){let t=0;for(let n=0;n<this.count;++n){let s=Math.abs(this.at(n,e));Number.isFinite(s)&&(t=Math.max(t,s))}return t}column(e){return Float64Array.from({length:this.count},(t,n)=>this.at(n,e))}};function Pm(i,e){let t=new Float32Array(e.buffer),n=i.runs?.map(o=>o.rows)??[i.rows],s=t.length/n.reduce((o,a)=>o+a,0),r=0;return n.map(o=>{let a=new Float32Array(o*s);for(let l=0;l<s;++l)for(let c=0;c<o;++c)a[c*s+l]=t[r+l*o+c];return r+=o*s,new qr(s,a)})}function Du(i){if(i.length===1)return i[0];let e=new Float32Array(i.reduce((n,s)=>n+s.values.length,0)),t=0;for(let n of i)e.set(n.values,t),t+=n.values.length;return new qr(i[0].width,e)}var or=class i{constructor(e,t,n){this.worker=e;this.width=t;this.told=n;e.onmessage=s=>this.arrived(s.data)}worker;width;told;busy=!1;waiting=null;number=0;static async begin(e,t,n,{tape:s="tape",by:r=[]}={}){if(e.live===!1||typeof WebAssembly>"u"||typeof Worker>"u")return null;try{let o=new Blob([await Xr("worker")],{type:"text/javascript"}),a=new Worker(URL.createObjectURL(o)),l={wasm:(await Xr("wasm")).buffer,tape:(await Xr(s)).buffer,start:e.start,stop:e.stop,rows:t,tolerance:e.tolerance,lasting:e.lasting,by:r,entries:e.blamed.entries.length},c=await new Promise((h,u)=>{a.onmessage=d=>h(d.data.ready),a.onerror=d=>u(new Error(d.message)),a.postMessage(l,[l.wasm,l.tape])});return new i(a,c,n)}catch{return null}}run(e,t,n=null){this.waiting={parameters:e,inputs:t,pull:n},this.busy||this.next()}next(){this.waiting!==null&&(this.worker.postMessage({number:++this.number,...this.waiting}),this.waiting=null,this.busy=!0)}arrived(e){this.busy=!1,this.told({...e,motion:new qr(this.width,e.rows)}),this.next()}};var Cy=300,Ry=12,Py=1e-9,Iy=["coordinate","rate","state","output"],Ly="The motion takes long: nothing is told of its end.",Dy="The motion ends before its time: its end moves, too.";function Ny(i,e){let{angle:t,group:n,display:s}=i,r=t&&n==="start";return e!==0&&!r?{si:.01*Math.abs(e),words:"1 %",ranked:!0}:{si:1/s.scale,words:`1 ${s.unit}`.trim(),ranked:r}}var wl=class{constructor(e,t){this.head=e;if(this.quantities=[...e.parameters,...e.inputs].filter((o,a)=>{let l=o.kind==="Real";return l&&this.by.push(a),l}),this.by.length===0||e.live===!1||e.modes!==void 0)return;let n=document.createElement("summary");n.textContent="What moves the end most",this.chooser.ariaLabel="The curve whose end moves",e.columns.slice(0,e.scene.first).forEach((o,a)=>{Iy.includes(o.kind)&&this.chooser.append(new Option(o.name,`${a}`))}),this.chooser.onchange=()=>this.show();let s=document.createElement("table");s.className="influence",s.append(this.rows),this.board.className="influences",this.board.open=!0,this.board.ontoggle=()=>this.ask();let r=document.createElement("div");r.append(this.chooser,this.told),this.board.append(n,r,s),t.append(this.board),e.differentiable||this.say("Delayed values have no derivatives yet.",!0)}head;by=[];quantities;board=document.createElement("details");chooser=document.createElement("select");told=document.createElement("p");rows=document.createElement("tbody");live=null;values=[];wish=null;timer=0;outcome=null;rest(e,t){!this.board.isConnected||!this.head.differentiable||(this.wish={parameters:e,inputs:t},this.board.ariaBusy="true",clearTimeout(this.timer),this.timer=setTimeout(()=>this.ask(),Cy))}ask(){if(this.wish===null||!this.board.open)return;let{parameters:e,inputs:t}=this.wish;this.wish=null;let n=[...e,...t];this.values=this.by.map(s=>n[s]),this.live??=or.begin(this.head,2,s=>this.arrived(s),{by:this.by}),this.live.then(s=>s?.run(e,t))}arrived(e){this.wish===null&&(this.board.ariaBusy="false",this.outcome=e,this.show(),document.documentElement.dataset.influence=e.took.toFixed(2))}say(e,t=!1){this.told.textContent=e,this.chooser.hidden=t}show(){if(this.outcome===null)return;let{status:e,derivatives:t,motion:n,time:s,blamed:r}=this.outcome;if(this.rows.replaceChildren(),t.length===0){let b=e===0||e===9?Dy:Sl(this.head,e,r);this.say(`${e===-1?Ly:b} (t = ${s.toPrecision(5)} s)`,!0);return}let o=Number(this.chooser.value),a=this.head.columns[o],{scale:l,shift:c,unit:h}=a.display,d=`is ${`${$i(n.at(n.count-1,o)*l+c,4)} ${h}`.trim()} at ${$i(s,4)} s`;this.say(`${d} and changes with`);let f=this.quantities.map((b,C)=>{let{si:v,words:R,ranked:E}=Ny(b,this.values[C]);return{name:b.name,words:R,ranked:E,change:t[C*n.width+o]*v*l}}),g=({change:b})=>Math.abs(b),M=Py*Math.max(...f.map(g)),m=f.filter(b=>g(b)>M).sort((b,C)=>g(C)-g(b)),p=m.filter(b=>b.ranked);m.length===0&&this.say(`${d}; no slider moves it.`);for(let b of[...p,...m.filter(C=>!C.ranked)].slice(0,Ry))this.row(b,b.ranked?g(b)/g(p[0]):0,h)}row({name:e,words:t,change:n},s,r){let o=document.createElement("tr"),a=document.createElement("th");a.scope="row",a.textContent=e.replace(/\.start$/," at the start");let l=document.createElement("td");l.textContent=t;let c=document.createElement("td");c.className="bar";let h=document.createElement("i");h.style.width=`${100*s}%`,h.className=n<0?"less":"more",s>0&&c.append(h);let u=document.createElement("td");u.textContent=`${n>0?"+":"\u2212"}${$i(Math.abs(n),3)} ${r}`.trim(),o.append(a,l,c,u),this.rows.append(o)}};var Uy=[[/^(Arrow|Home|End)/,"input:not([type=checkbox]):not([aria-label=Time]), select, [role=tab]"],[/^[+-]$/,"input[type=number]"]];function Im(i){let e=t=>{if(t.ctrlKey||t.metaKey||t.altKey||!(t.target instanceof Element))return;let{key:n,target:s}=t;return Uy.some(([r,o])=>r.test(n)&&s.matches(o))?void 0:i[n]};document.addEventListener("keydown",t=>{let n=e(t);n!==void 0&&(t.preventDefault(),n())}),document.addEventListener("keyup",t=>t.key===" "&&e(t)!==void 0&&t.preventDefault())}var qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},dg=0,ud=1,fg=2;var Ra=1,pg=2,Eo=3,$s=0,$n=1,Zn=2,gr=0,Co=1,dd=2,fd=3,pd=4,mg=5;var _r=100,gg=101,_g=102,xg=103,yg=104,vg=200,bg=201,Mg=202,Sg=203,md=204,gd=205,wg=206,Tg=207,Ag=208,Eg=209,Cg=210,Rg=211,Pg=212,Ig=213,Lg=214,jl=0,Ql=1,ec=2,uo=3,tc=4,nc=5,ic=6,sc=7,Pc=0,Dg=1,Ng=2,es=0,_d=1,xd=2,yd=3,vd=4,bd=5,Md=6,Sd=7;var wd=300,xr=301,Ro=302,Ic=303,Lc=304,rc=1e3,Ji=1001,oc=1002,Rn=1003,Ug=1004;var Pa=1005;var qn=1006,Dc=1007;var bs=1008;var Kn=1009,Td=1010,Ad=1011,Po=1012,Nc=1013,Oi=1014,Fi=1015,Bi=1016,Uc=1017,Oc=1018,yr=1020,Ed=35902,Cd=35899,Rd=1021,Pd=1022,ki=1023,_s=1026,Ms=1027,Id=1028,Fc=1029,Zs=1030,Bc=1031;var kc=1033,Ia=33776,La=33777,Da=33778,Na=33779,zc=35840,Gc=35841,Hc=35842,Vc=35843,Wc=36196,Xc=37492,qc=37496,Yc=37488,$c=37489,Ua=37490,Zc=37491,Jc=37808,Kc=37809,jc=37810,Qc=37811,eh=37812,th=37813,nh=37814,ih=37815,sh=37816,rh=37817,oh=37818,ah=37819,lh=37820,ch=37821,hh=36492,uh=36494,dh=36495,fh=36283,ph=36284,Oa=36285,mh=36286;var aa=2300,ac=2301,Jl=2302,id=2303,sd=2400,rd=2401,od=2402;var Og=3200;var gh=0,Fg=1,Ss="",Vn="srgb",la="srgb-linear",ca="linear",Ut="srgb";var Kl=7680;var Bg=519,kg=512,zg=513,Gg=514,Ld=515,Hg=516,Vg=517,Dd=518,Nd=519,Ud=35044;var Od="300 es",vi=2e3,fo=2001;function Oy(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Fy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ha(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Wg(){let i=ha("canvas");return i.style.display="block",i}var Lm={},po=null;function ua(...i){let e="THREE."+i.shift();po?po("log",e,...i):console.log(e,...i)}function Xg(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function rt(...i){i=Xg(i);let e="THREE."+i.shift();if(po)po("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ht(...i){i=Xg(i);let e="THREE."+i.shift();if(po)po("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function sa(...i){let e=i.join(" ");e in Lm||(Lm[e]=!0,rt(...i))}function qg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Yg={[jl]:jl,[ec]:ic,[tc]:tc,[uo]:nc,[Ql]:Ql,[ic]:ec,[sc]:sc,[nc]:uo},Li=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Nn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Dm=1234567,ra=Math.PI/180,mo=180/Math.PI;function Js(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Nn[i&255]+Nn[i>>8&255]+Nn[i>>16&255]+Nn[i>>24&255]+"-"+Nn[e&255]+Nn[e>>8&255]+"-"+Nn[e>>16&15|64]+Nn[e>>24&255]+"-"+Nn[t&63|128]+Nn[t>>8&255]+"-"+Nn[t>>16&255]+Nn[t>>24&255]+Nn[n&255]+Nn[n>>8&255]+Nn[n>>16&255]+Nn[n>>24&255]).toLowerCase()}function Mt(i,e,t){return Math.max(e,Math.min(t,i))}function Fd(i,e){return(i%e+e)%e}function By(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function ky(i,e,t){return i!==e?(t-i)/(e-i):0}function oa(i,e,t){return(1-t)*i+t*e}function zy(i,e,t,n){return oa(i,e,1-Math.exp(-t*n))}function Gy(i,e=1){return e-Math.abs(Fd(i,e*2)-e)}function Hy(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Vy(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Wy(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Xy(i,e){return i+Math.random()*(e-i)}function qy(i){return i*(.5-Math.random())}function Yy(i){i!==void 0&&(Dm=i);let e=Dm+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function $y(i){return i*ra}function Zy(i){return i*mo}function Jy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ky(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Bd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function jy(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:rt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function _h(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function kd(i,e){if(e.constructor===Float32Array)return i;let t=_h(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function zd(i,e){if(e.constructor===Float32Array)return i;let t=_h(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var xh={DEG2RAD:ra,RAD2DEG:mo,generateUUID:Js,clamp:Mt,euclideanModulo:Fd,mapLinear:By,inverseLerp:ky,lerp:oa,damp:zy,pingpong:Gy,smoothstep:Hy,smootherstep:Vy,randInt:Wy,randFloat:Xy,randFloatSpread:qy,seededRandom:Yy,degToRad:$y,radToDeg:Zy,isPowerOfTwo:Jy,ceilPowerOfTwo:Ky,floorPowerOfTwo:Bd,setQuaternionFromProperEuler:jy,normalize:zd,denormalize:kd},Xe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},li=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],M=r[o+3];if(u!==M||l!==d||c!==f||h!==g){let m=l*d+c*f+h*g+u*M;m<0&&(d=-d,f=-f,g=-g,M=-M,m=-m);let p=1-a;if(m<.9995){let b=Math.acos(m),C=Math.sin(b);p=Math.sin(p*b)/C,a=Math.sin(a*b)/C,l=l*p+d*a,c=c*p+f*a,h=h*p+g*a,u=u*p+M*a}else{l=l*p+d*a,c=c*p+f*a,h=h*p+g*a,u=u*p+M*a;let b=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=b,c*=b,h*=b,u*=b}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:rt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Mt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Nm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Nm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this.z=Mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this.z=Mt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Uu.copy(this).projectOnVector(e),this.sub(Uu)}reflect(e){return this.sub(Uu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Uu=new F,Nm=new li,at=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],M=s[0],m=s[3],p=s[6],b=s[1],C=s[4],v=s[7],R=s[2],E=s[5],_=s[8];return r[0]=o*M+a*b+l*R,r[3]=o*m+a*C+l*E,r[6]=o*p+a*v+l*_,r[1]=c*M+h*b+u*R,r[4]=c*m+h*C+u*E,r[7]=c*p+h*v+u*_,r[2]=d*M+f*b+g*R,r[5]=d*m+f*C+g*E,r[8]=d*p+f*v+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return e[0]=u*M,e[1]=(s*c-h*n)*M,e[2]=(a*n-s*o)*M,e[3]=d*M,e[4]=(h*t-s*l)*M,e[5]=(s*r-a*t)*M,e[6]=f*M,e[7]=(n*l-c*t)*M,e[8]=(o*t-n*r)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return sa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ou.makeScale(e,t)),this}rotate(e){return sa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ou.makeRotation(-e)),this}translate(e,t){return sa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ou.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ou=new at,Um=new at().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Om=new at().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Qy(){let i={enabled:!0,workingColorSpace:la,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ut&&(s.r=gs(s.r),s.g=gs(s.g),s.b=gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ut&&(s.r=ho(s.r),s.g=ho(s.g),s.b=ho(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ss?ca:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[la]:{primaries:e,whitePoint:n,transfer:ca,toXYZ:Um,fromXYZ:Om,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Vn},outputColorSpaceConfig:{drawingBufferColorSpace:Vn}},[Vn]:{primaries:e,whitePoint:n,transfer:Ut,toXYZ:Um,fromXYZ:Om,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Vn}}}),i}var At=Qy();function gs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ho(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Yr,lc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Yr===void 0&&(Yr=ha("canvas")),Yr.width=e.width,Yr.height=e.height;let s=Yr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Yr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ha("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=gs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(gs(t[n]/255)*255):t[n]=gs(t[n]);return{data:t,width:e.width,height:e.height}}else return rt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ev=0,go=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ev++}),this.uuid=Js(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Fu(s[o].image)):r.push(Fu(s[o]))}else r=Fu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Fu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?lc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(rt("Texture: Unable to serialize Texture."),{})}var tv=0,Bu=new F,Yn=class i extends Li{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ji,s=Ji,r=qn,o=bs,a=ki,l=Kn,c=i.DEFAULT_ANISOTROPY,h=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:tv++}),this.uuid=Js(),this.name="",this.source=new go(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Xe(0,0),this.repeat=new Xe(1,1),this.center=new Xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new at,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Bu).x}get height(){return this.source.getSize(Bu).y}get depth(){return this.source.getSize(Bu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){rt(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){rt(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==wd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case rc:e.x=e.x-Math.floor(e.x);break;case Ji:e.x=e.x<0?0:1;break;case oc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case rc:e.y=e.y-Math.floor(e.y);break;case Ji:e.y=e.y<0?0:1;break;case oc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Yn.DEFAULT_IMAGE=null;Yn.DEFAULT_MAPPING=wd;Yn.DEFAULT_ANISOTROPY=1;var Rt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],M=l[2],m=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-M)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+M)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,v=(f+1)/2,R=(p+1)/2,E=(h+d)/4,_=(u+M)/4,T=(g+m)/4;return C>v&&C>R?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=E/n,r=_/n):v>R?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=E/s,r=T/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=_/r,s=T/r),this.set(n,s,r,t),this}let b=Math.sqrt((m-g)*(m-g)+(u-M)*(u-M)+(d-h)*(d-h));return Math.abs(b)<.001&&(b=1),this.x=(m-g)/b,this.y=(u-M)/b,this.z=(d-h)/b,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this.z=Mt(this.z,e.z,t.z),this.w=Mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this.z=Mt(this.z,e,t),this.w=Mt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},cc=class extends Li{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Rt(0,0,e,t),this.scissorTest=!1,this.viewport=new Rt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Yn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new go(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ci=class extends cc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},da=class extends Yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var hc=class extends Yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var gt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,M,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,M,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,M,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=g,p[11]=M,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/$r.setFromMatrixColumn(e,0).length(),r=1/$r.setFromMatrixColumn(e,1).length(),o=1/$r.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,M=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-M*c,t[9]=-a*l,t[2]=M-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,M=c*u;t[0]=d+M*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=M+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,M=c*u;t[0]=d-M*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=M-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,M=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+M,t[1]=l*u,t[5]=M*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,M=a*c;t[0]=l*h,t[4]=M-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-M*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,M=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+M,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=M*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(nv,e,iv)}lookAt(e,t,n){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Os.crossVectors(n,oi),Os.lengthSq()===0&&(Math.abs(n.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Os.crossVectors(n,oi)),Os.normalize(),Tl.crossVectors(oi,Os),s[0]=Os.x,s[4]=Tl.x,s[8]=oi.x,s[1]=Os.y,s[5]=Tl.y,s[9]=oi.y,s[2]=Os.z,s[6]=Tl.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],M=n[6],m=n[10],p=n[14],b=n[3],C=n[7],v=n[11],R=n[15],E=s[0],_=s[4],T=s[8],B=s[12],N=s[1],D=s[5],k=s[9],W=s[13],L=s[2],H=s[6],q=s[10],V=s[14],ce=s[3],Y=s[7],j=s[11],ie=s[15];return r[0]=o*E+a*N+l*L+c*ce,r[4]=o*_+a*D+l*H+c*Y,r[8]=o*T+a*k+l*q+c*j,r[12]=o*B+a*W+l*V+c*ie,r[1]=h*E+u*N+d*L+f*ce,r[5]=h*_+u*D+d*H+f*Y,r[9]=h*T+u*k+d*q+f*j,r[13]=h*B+u*W+d*V+f*ie,r[2]=g*E+M*N+m*L+p*ce,r[6]=g*_+M*D+m*H+p*Y,r[10]=g*T+M*k+m*q+p*j,r[14]=g*B+M*W+m*V+p*ie,r[3]=b*E+C*N+v*L+R*ce,r[7]=b*_+C*D+v*H+R*Y,r[11]=b*T+C*k+v*q+R*j,r[15]=b*B+C*W+v*V+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],M=e[7],m=e[11],p=e[15],b=l*f-c*d,C=a*f-c*u,v=a*d-l*u,R=o*f-c*h,E=o*d-l*h,_=o*u-a*h;return t*(M*b-m*C+p*v)-n*(g*b-m*R+p*E)+s*(g*C-M*R+p*_)-r*(g*v-M*E+m*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],M=e[13],m=e[14],p=e[15],b=t*a-n*o,C=t*l-s*o,v=t*c-r*o,R=n*l-s*a,E=n*c-r*a,_=s*c-r*l,T=h*M-u*g,B=h*m-d*g,N=h*p-f*g,D=u*m-d*M,k=u*p-f*M,W=d*p-f*m,L=b*W-C*k+v*D+R*N-E*B+_*T;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/L;return e[0]=(a*W-l*k+c*D)*H,e[1]=(s*k-n*W-r*D)*H,e[2]=(M*_-m*E+p*R)*H,e[3]=(d*E-u*_-f*R)*H,e[4]=(l*N-o*W-c*B)*H,e[5]=(t*W-s*N+r*B)*H,e[6]=(m*v-g*_-p*C)*H,e[7]=(h*_-d*v+f*C)*H,e[8]=(o*k-a*N+c*T)*H,e[9]=(n*N-t*k-r*T)*H,e[10]=(g*E-M*v+p*b)*H,e[11]=(u*v-h*E-f*b)*H,e[12]=(a*B-o*D-l*T)*H,e[13]=(t*D-n*B+s*T)*H,e[14]=(M*C-g*R-m*b)*H,e[15]=(h*R-u*C+d*b)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,M=o*h,m=o*u,p=a*u,b=l*c,C=l*h,v=l*u,R=n.x,E=n.y,_=n.z;return s[0]=(1-(M+p))*R,s[1]=(f+v)*R,s[2]=(g-C)*R,s[3]=0,s[4]=(f-v)*E,s[5]=(1-(d+p))*E,s[6]=(m+b)*E,s[7]=0,s[8]=(g+C)*_,s[9]=(m-b)*_,s[10]=(1-(d+M))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=$r.set(s[0],s[1],s[2]).length(),a=$r.set(s[4],s[5],s[6]).length(),l=$r.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ri.copy(this);let c=1/o,h=1/a,u=1/l;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=h,Ri.elements[5]*=h,Ri.elements[6]*=h,Ri.elements[8]*=u,Ri.elements[9]*=u,Ri.elements[10]*=u,t.setFromRotationMatrix(Ri),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=vi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,M;if(l)g=r/(o-r),M=o*r/(o-r);else if(a===vi)g=-(o+r)/(o-r),M=-2*o*r/(o-r);else if(a===fo)g=-o/(o-r),M=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=vi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,M;if(l)g=1/(o-r),M=o/(o-r);else if(a===vi)g=-2/(o-r),M=-(o+r)/(o-r);else if(a===fo)g=-1/(o-r),M=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},$r=new F,Ri=new gt,nv=new F(0,0,0),iv=new F(1,1,1),Os=new F,Tl=new F,oi=new F,Fm=new gt,Bm=new li,xs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Mt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Mt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Mt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:rt("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Fm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Fm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Bm.setFromEuler(this),this.setFromQuaternion(Bm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};xs.DEFAULT_ORDER="XYZ";var _o=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},sv=0,km=new F,Zr=new li,hs=new gt,Al=new F,Jo=new F,rv=new F,ov=new li,zm=new F(1,0,0),Gm=new F(0,1,0),Hm=new F(0,0,1),Vm={type:"added"},av={type:"removed"},Jr={type:"childadded",child:null},ku={type:"childremoved",child:null},yn=class i extends Li{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:sv++}),this.uuid=Js(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new F,t=new xs,n=new li,s=new F(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new gt},normalMatrix:{value:new at}}),this.matrix=new gt,this.matrixWorld=new gt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new _o,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Zr.setFromAxisAngle(e,t),this.quaternion.multiply(Zr),this}rotateOnWorldAxis(e,t){return Zr.setFromAxisAngle(e,t),this.quaternion.premultiply(Zr),this}rotateX(e){return this.rotateOnAxis(zm,e)}rotateY(e){return this.rotateOnAxis(Gm,e)}rotateZ(e){return this.rotateOnAxis(Hm,e)}translateOnAxis(e,t){return km.copy(e).applyQuaternion(this.quaternion),this.position.add(km.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(zm,e)}translateY(e){return this.translateOnAxis(Gm,e)}translateZ(e){return this.translateOnAxis(Hm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(hs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Al.copy(e):Al.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Jo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?hs.lookAt(Jo,Al,this.up):hs.lookAt(Al,Jo,this.up),this.quaternion.setFromRotationMatrix(hs),s&&(hs.extractRotation(s.matrixWorld),Zr.setFromRotationMatrix(hs),this.quaternion.premultiply(Zr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ht("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Vm),Jr.child=e,this.dispatchEvent(Jr),Jr.child=null):ht("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(av),ku.child=e,this.dispatchEvent(ku),ku.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),hs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),hs.multiply(e.parent.matrixWorld)),e.applyMatrix4(hs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Vm),Jr.child=e,this.dispatchEvent(Jr),Jr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Jo,e,rv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Jo,ov,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};yn.DEFAULT_UP=new F(0,1,0);yn.DEFAULT_MATRIX_AUTO_UPDATE=!0;yn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var In=class extends yn{constructor(){super(),this.isGroup=!0,this.type="Group"}},lv={type:"move"},xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new In,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new In,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new In,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let m=t.getJointPose(M,n),p=this._getHandJoint(c,M);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(lv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new In;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},$g={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fs={h:0,s:0,l:0},El={h:0,s:0,l:0};function zu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var nt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,At.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=At.workingColorSpace){return this.r=e,this.g=t,this.b=n,At.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=At.workingColorSpace){if(e=Fd(e,1),t=Mt(t,0,1),n=Mt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=zu(o,r,e+1/3),this.g=zu(o,r,e),this.b=zu(o,r,e-1/3)}return At.colorSpaceToWorking(this,s),this}setStyle(e,t=Vn){function n(r){r!==void 0&&parseFloat(r)<1&&rt("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:rt("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);rt("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Vn){let n=$g[e.toLowerCase()];return n!==void 0?this.setHex(n,t):rt("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=gs(e.r),this.g=gs(e.g),this.b=gs(e.b),this}copyLinearToSRGB(e){return this.r=ho(e.r),this.g=ho(e.g),this.b=ho(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Vn){return At.workingToColorSpace(Un.copy(this),e),Math.round(Mt(Un.r*255,0,255))*65536+Math.round(Mt(Un.g*255,0,255))*256+Math.round(Mt(Un.b*255,0,255))}getHexString(e=Vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=At.workingColorSpace){At.workingToColorSpace(Un.copy(this),t);let n=Un.r,s=Un.g,r=Un.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=At.workingColorSpace){return At.workingToColorSpace(Un.copy(this),t),e.r=Un.r,e.g=Un.g,e.b=Un.b,e}getStyle(e=Vn){At.workingToColorSpace(Un.copy(this),e);let t=Un.r,n=Un.g,s=Un.b;return e!==Vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Fs),this.setHSL(Fs.h+e,Fs.s+t,Fs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Fs),e.getHSL(El);let n=oa(Fs.h,El.h,t),s=oa(Fs.s,El.s,t),r=oa(Fs.l,El.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Un=new nt;nt.NAMES=$g;var ur=class extends yn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new xs,this.environmentIntensity=1,this.environmentRotation=new xs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Pi=new F,us=new F,Gu=new F,ds=new F,Kr=new F,jr=new F,Wm=new F,Hu=new F,Vu=new F,Wu=new F,Xu=new Rt,qu=new Rt,Yu=new Rt,ms=class i{constructor(e=new F,t=new F,n=new F){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Pi.subVectors(e,t),s.cross(Pi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Pi.subVectors(s,t),us.subVectors(n,t),Gu.subVectors(e,t);let o=Pi.dot(Pi),a=Pi.dot(us),l=Pi.dot(Gu),c=us.dot(us),h=us.dot(Gu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Xu.setScalar(0),qu.setScalar(0),Yu.setScalar(0),Xu.fromBufferAttribute(e,t),qu.fromBufferAttribute(e,n),Yu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Xu,r.x),o.addScaledVector(qu,r.y),o.addScaledVector(Yu,r.z),o}static isFrontFacing(e,t,n,s){return Pi.subVectors(n,t),us.subVectors(e,t),Pi.cross(us).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Pi.subVectors(this.c,this.b),us.subVectors(this.a,this.b),Pi.cross(us).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Kr.subVectors(s,n),jr.subVectors(r,n),Hu.subVectors(e,n);let l=Kr.dot(Hu),c=jr.dot(Hu);if(l<=0&&c<=0)return t.copy(n);Vu.subVectors(e,s);let h=Kr.dot(Vu),u=jr.dot(Vu);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Kr,o);Wu.subVectors(e,r);let f=Kr.dot(Wu),g=jr.dot(Wu);if(g>=0&&f<=g)return t.copy(r);let M=f*c-l*g;if(M<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(jr,a);let m=h*g-f*u;if(m<=0&&u-h>=0&&f-g>=0)return Wm.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(Wm,a);let p=1/(m+M+d);return o=M*p,a=d*p,t.copy(n).addScaledVector(Kr,o).addScaledVector(jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},hi=class{constructor(e=new F(1/0,1/0,1/0),t=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ii.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ii.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ii.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ii):Ii.fromBufferAttribute(r,o),Ii.applyMatrix4(e.matrixWorld),this.expandByPoint(Ii);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Cl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Cl.copy(n.boundingBox)),Cl.applyMatrix4(e.matrixWorld),this.union(Cl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ii),Ii.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ko),Rl.subVectors(this.max,Ko),Qr.subVectors(e.a,Ko),eo.subVectors(e.b,Ko),to.subVectors(e.c,Ko),Bs.subVectors(eo,Qr),ks.subVectors(to,eo),ar.subVectors(Qr,to);let t=[0,-Bs.z,Bs.y,0,-ks.z,ks.y,0,-ar.z,ar.y,Bs.z,0,-Bs.x,ks.z,0,-ks.x,ar.z,0,-ar.x,-Bs.y,Bs.x,0,-ks.y,ks.x,0,-ar.y,ar.x,0];return!$u(t,Qr,eo,to,Rl)||(t=[1,0,0,0,1,0,0,0,1],!$u(t,Qr,eo,to,Rl))?!1:(Pl.crossVectors(Bs,ks),t=[Pl.x,Pl.y,Pl.z],$u(t,Qr,eo,to,Rl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ii).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ii).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(fs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),fs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),fs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),fs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),fs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),fs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),fs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),fs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(fs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},fs=[new F,new F,new F,new F,new F,new F,new F,new F],Ii=new F,Cl=new hi,Qr=new F,eo=new F,to=new F,Bs=new F,ks=new F,ar=new F,Ko=new F,Rl=new F,Pl=new F,lr=new F;function $u(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){lr.fromArray(i,r);let a=s.x*Math.abs(lr.x)+s.y*Math.abs(lr.y)+s.z*Math.abs(lr.z),l=e.dot(lr),c=t.dot(lr),h=n.dot(lr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var pn=new F,Il=new Xe,cv=0,Cn=class extends Li{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:cv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ud,this.updateRanges=[],this.gpuType=Fi,this.version=0,this._normalizationScale=e!==void 0?_h(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Il.fromBufferAttribute(this,t),Il.applyMatrix3(e),this.setXY(t,Il.x,Il.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix3(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix4(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyNormalMatrix(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.transformDirection(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):kd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):zd(e,this.array)}};var fa=class extends Cn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var pa=class extends Cn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var zt=class extends Cn{constructor(e,t,n){super(new Float32Array(e),t,n)}},hv=new hi,jo=new F,Zu=new F,dr=class{constructor(e=new F,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):hv.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;jo.subVectors(e,this.center);let t=jo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(jo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Zu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(jo.copy(e.center).add(Zu)),this.expandByPoint(jo.copy(e.center).sub(Zu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},uv=0,yi=new gt,Ju=new yn,no=new F,ai=new hi,Qo=new hi,En=new F,en=class i extends Li{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uv++}),this.uuid=Js(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Oy(e)?pa:fa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new at().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return yi.makeRotationFromQuaternion(e),this.applyMatrix4(yi),this}rotateX(e){return yi.makeRotationX(e),this.applyMatrix4(yi),this}rotateY(e){return yi.makeRotationY(e),this.applyMatrix4(yi),this}rotateZ(e){return yi.makeRotationZ(e),this.applyMatrix4(yi),this}translate(e,t,n){return yi.makeTranslation(e,t,n),this.applyMatrix4(yi),this}scale(e,t,n){return yi.makeScale(e,t,n),this.applyMatrix4(yi),this}lookAt(e){return Ju.lookAt(e),Ju.updateMatrix(),this.applyMatrix4(Ju.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(no).negate(),this.translate(no.x,no.y,no.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new zt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&rt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new hi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(En.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(En),En.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(En)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ht('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new dr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(e){let n=this.boundingSphere.center;if(ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Qo.setFromBufferAttribute(a),this.morphTargetsRelative?(En.addVectors(ai.min,Qo.min),ai.expandByPoint(En),En.addVectors(ai.max,Qo.max),ai.expandByPoint(En)):(ai.expandByPoint(Qo.min),ai.expandByPoint(Qo.max))}ai.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)En.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(En));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)En.fromBufferAttribute(a,c),l&&(no.fromBufferAttribute(e,c),En.add(no)),s=Math.max(s,n.distanceToSquared(En))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ht('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ht("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Cn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let B=0;B<n.count;B++)a[B]=new F,l[B]=new F;let h=new F,u=new F,d=new F,f=new Xe,g=new Xe,M=new Xe,m=new F,p=new F;function b(B,N,D){c[B]=c[N]=c[D]=1,h.fromBufferAttribute(n,B),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,B),g.fromBufferAttribute(r,N),M.fromBufferAttribute(r,D),u.sub(h),d.sub(h),g.sub(f),M.sub(f);let k=1/(g.x*M.y-M.x*g.y);isFinite(k)&&(m.copy(u).multiplyScalar(M.y).addScaledVector(d,-g.y).multiplyScalar(k),p.copy(d).multiplyScalar(g.x).addScaledVector(u,-M.x).multiplyScalar(k),a[B].add(m),a[N].add(m),a[D].add(m),l[B].add(p),l[N].add(p),l[D].add(p))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let B=0,N=C.length;B<N;++B){let D=C[B],k=D.start,W=D.count;for(let L=k,H=k+W;L<H;L+=3)b(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let v=new F,R=new F,E=new F,_=new F;function T(B){E.fromBufferAttribute(s,B),_.copy(E);let N=a[B];v.copy(N),v.sub(E.multiplyScalar(E.dot(N))).normalize(),R.crossVectors(_,N);let k=R.dot(l[B])<0?-1:1;o.setXYZW(B,v.x,v.y,v.z,k)}for(let B=0,N=n.count;B<N;++B)c[B]&&T(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Cn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),M=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,M),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,M),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(M,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)En.fromBufferAttribute(e,t),En.normalize(),e.setXYZ(t,En.x,En.y,En.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let M=0,m=l.length;M<m;M++){a.isInterleavedBufferAttribute?f=l[M]*a.data.stride+a.offset:f=l[M]*h;for(let p=0;p<h;p++)d[g++]=c[f++]}return new Cn(d,h,u)}if(this.index===null)return rt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ma=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Ud,this.updateRanges=[],this.version=0,this.uuid=Js()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Xm(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Xm(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Xm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Js()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Hn=new F,yo=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?_h(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.applyMatrix4(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.applyNormalMatrix(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.transformDirection(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){ua("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Cn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){ua("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):kd(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):zd(e,this.data.array)}},Ku=new F,dv=new F,fv=new at,Wn=class{constructor(e=new F(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Ku.subVectors(n,t).cross(dv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Ku),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||fv.getNormalMatrix(e),s=this.coplanarPoint(Ku).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},pv=0,Ki=class extends Li{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:pv++}),this.uuid=Js(),this.name="",this.type="Material",this.blending=Co,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=md,this.blendDst=gd,this.blendEquation=_r,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new nt(0,0,0),this.blendAlpha=0,this.depthFunc=uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Bg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Kl,this.stencilZFail=Kl,this.stencilZPass=Kl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){rt(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){rt(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new nt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Wn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Xe().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},vo=class extends Ki{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new nt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},io,ea=new F,so=new F,ro=new F,oo=new Xe,ta=new Xe,Zg=new gt,Ll=new F,na=new F,Dl=new F,qm=new Xe,ju=new Xe,Ym=new Xe,Di=class extends yn{constructor(e=new vo){if(super(),this.isSprite=!0,this.type="Sprite",io===void 0){io=new en;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new ma(t,5);io.setIndex([0,1,2,0,2,3]),io.setAttribute("position",new yo(n,3,0,!1)),io.setAttribute("uv",new yo(n,2,3,!1))}this.geometry=io,this.material=e,this.center=new Xe(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&ht('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),so.setFromMatrixScale(this.matrixWorld),Zg.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),ro.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&so.multiplyScalar(-ro.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Nl(Ll.set(-.5,-.5,0),ro,o,so,s,r),Nl(na.set(.5,-.5,0),ro,o,so,s,r),Nl(Dl.set(.5,.5,0),ro,o,so,s,r),qm.set(0,0),ju.set(1,0),Ym.set(1,1);let a=e.ray.intersectTriangle(Ll,na,Dl,!1,ea);if(a===null&&(Nl(na.set(-.5,.5,0),ro,o,so,s,r),ju.set(0,1),a=e.ray.intersectTriangle(Ll,Dl,na,!1,ea),a===null))return;let l=e.ray.origin.distanceTo(ea);l<e.near||l>e.far||t.push({distance:l,point:ea.clone(),uv:ms.getInterpolation(ea,Ll,na,Dl,qm,ju,Ym,new Xe),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function Nl(i,e,t,n,s,r){oo.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(ta.x=r*oo.x-s*oo.y,ta.y=s*oo.x+r*oo.y):ta.copy(oo),i.copy(e),i.x+=ta.x,i.y+=ta.y,i.applyMatrix4(Zg)}var ps=new F,Qu=new F,Ul=new F,Ol=new F,Gs=class{constructor(e=new F,t=new F(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ps)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ps.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ps.copy(this.origin).addScaledVector(this.direction,t),ps.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Qu.copy(e).add(t).multiplyScalar(.5),Ul.copy(t).sub(e).normalize(),Ol.copy(this.origin).sub(Qu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ul),a=Ol.dot(this.direction),l=-Ol.dot(Ul),c=Ol.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let M=1/h;u*=M,d*=M,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Qu).addScaledVector(Ul,d),f}intersectSphere(e,t){if(e.radius<0)return null;ps.subVectors(e.center,this.origin);let n=ps.dot(this.direction),s=ps.dot(ps)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ps)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,M=t.y-o.y,m=t.z-o.z,p=n.x-o.x,b=n.y-o.y,C=n.z-o.z,v=Math.abs(l),R=Math.abs(c),E=Math.abs(h),_,T,B,N,D,k,W,L,H,q,V,ce;if(v>=R&&v>=E?(B=l,k=u,H=g,ce=p,l>=0?(_=c,T=h,N=d,D=f,W=M,L=m,q=b,V=C):(_=h,T=c,N=f,D=d,W=m,L=M,q=C,V=b)):R>=E?(B=c,k=d,H=M,ce=b,c>=0?(_=h,T=l,N=f,D=u,W=m,L=g,q=C,V=p):(_=l,T=h,N=u,D=f,W=g,L=m,q=p,V=C)):(B=h,k=f,H=m,ce=C,h>=0?(_=l,T=c,N=u,D=d,W=g,L=M,q=p,V=b):(_=c,T=l,N=d,D=u,W=M,L=g,q=b,V=p)),B===0)return null;let Y=_/B,j=T/B,ie=1/B,pe=N-Y*k,he=D-j*k,ee=W-Y*H,ge=L-j*H,Me=q-Y*ce,Le=V-j*ce,Ee=Me*ge-Le*ee,je=pe*Le-he*Me,ut=ee*he-ge*pe;if(s){if(Ee<0||je<0||ut<0)return null}else if((Ee<0||je<0||ut<0)&&(Ee>0||je>0||ut>0))return null;let Je=Ee+je+ut;if(Je===0)return null;let ft=ie*(Ee*k+je*H+ut*ce);return(Je>0?ft<0:ft>0)?null:this.at(ft/Je,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},bo=class extends Ki{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xs,this.combine=Pc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},$m=new gt,cr=new Gs,Fl=new dr,Zm=new F,Bl=new F,kl=new F,zl=new F,ed=new F,Gl=new F,Jm=new F,Hl=new F,tn=class extends yn{constructor(e=new en,t=new bo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Gl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(ed.fromBufferAttribute(u,e),o?Gl.addScaledVector(ed,h):Gl.addScaledVector(ed.sub(t),h))}t.add(Gl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Fl.copy(n.boundingSphere),Fl.applyMatrix4(r),cr.copy(e.ray).recast(e.near),!(Fl.containsPoint(cr.origin)===!1&&(cr.intersectSphere(Fl,Zm)===null||cr.origin.distanceToSquared(Zm)>(e.far-e.near)**2))&&($m.copy(r).invert(),cr.copy(e.ray).applyMatrix4($m),!(n.boundingBox!==null&&cr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,cr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,M=d.length;g<M;g++){let m=d[g],p=o[m.materialIndex],b=Math.max(m.start,f.start),C=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=b,R=C;v<R;v+=3){let E=a.getX(v),_=a.getX(v+1),T=a.getX(v+2);s=Vl(this,p,e,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),M=Math.min(a.count,f.start+f.count);for(let m=g,p=M;m<p;m+=3){let b=a.getX(m),C=a.getX(m+1),v=a.getX(m+2);s=Vl(this,o,e,n,c,h,u,b,C,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,M=d.length;g<M;g++){let m=d[g],p=o[m.materialIndex],b=Math.max(m.start,f.start),C=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=b,R=C;v<R;v+=3){let E=v,_=v+1,T=v+2;s=Vl(this,p,e,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),M=Math.min(l.count,f.start+f.count);for(let m=g,p=M;m<p;m+=3){let b=m,C=m+1,v=m+2;s=Vl(this,o,e,n,c,h,u,b,C,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function mv(i,e,t,n,s,r,o,a){let l;if(e.side===$n?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===$s,a),l===null)return null;Hl.copy(a),Hl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Hl);return c<t.near||c>t.far?null:{distance:c,point:Hl.clone(),object:i}}function Vl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Bl),i.getVertexPosition(l,kl),i.getVertexPosition(c,zl);let h=mv(i,e,t,n,Bl,kl,zl,Jm);if(h){let u=new F;ms.getBarycoord(Jm,Bl,kl,zl,u),s&&(h.uv=ms.getInterpolatedAttribute(s,a,l,c,u,new Xe)),r&&(h.uv1=ms.getInterpolatedAttribute(r,a,l,c,u,new Xe)),o&&(h.normal=ms.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new F,materialIndex:0};ms.getNormal(Bl,kl,zl,d.normal),h.face=d,h.barycoord=u}return h}var uc=class extends Yn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Rn,h=Rn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var hr=new dr,gv=new Xe(.5,.5),Wl=new F,ji=class{constructor(e=new Wn,t=new Wn,n=new Wn,s=new Wn,r=new Wn,o=new Wn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=vi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],M=r[9],m=r[10],p=r[11],b=r[12],C=r[13],v=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,p-g,R-b).normalize(),s[1].setComponents(c+o,f+h,p+g,R+b).normalize(),s[2].setComponents(c+a,f+u,p+M,R+C).normalize(),s[3].setComponents(c-a,f-u,p-M,R-C).normalize(),n)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,f-d,p-m,R-v).normalize();else if(s[4].setComponents(c-l,f-d,p-m,R-v).normalize(),t===vi)s[5].setComponents(c+l,f+d,p+m,R+v).normalize();else if(t===fo)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),hr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),hr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(hr)}intersectsSprite(e){hr.center.set(0,0,0);let t=gv.distanceTo(e.center);return hr.radius=.7071067811865476+t,hr.applyMatrix4(e.matrixWorld),this.intersectsSphere(hr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Wl.x=s.normal.x>0?e.max.x:e.min.x,Wl.y=s.normal.y>0?e.max.y:e.min.y,Wl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Wl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Km=new gt,dc=class i{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Km.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ji),n[s].setFromProjectionMatrix(Km,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ji),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Hs=class extends Ki{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},fc=new F,pc=new F,jm=new gt,ia=new Gs,Xl=new dr,td=new F,Qm=new F,ys=class extends yn{constructor(e=new en,t=new Hs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)fc.fromBufferAttribute(t,s-1),pc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=fc.distanceTo(pc);e.setAttribute("lineDistance",new zt(n,1))}else rt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Xl.copy(n.boundingSphere),Xl.applyMatrix4(s),Xl.radius+=r,e.ray.intersectsSphere(Xl)===!1)return;jm.copy(s).invert(),ia.copy(e.ray).applyMatrix4(jm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let M=f,m=g-1;M<m;M+=c){let p=h.getX(M),b=h.getX(M+1),C=ql(this,e,ia,l,p,b,M);C&&t.push(C)}if(this.isLineLoop){let M=h.getX(g-1),m=h.getX(f),p=ql(this,e,ia,l,M,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let M=f,m=g-1;M<m;M+=c){let p=ql(this,e,ia,l,M,M+1,M);p&&t.push(p)}if(this.isLineLoop){let M=ql(this,e,ia,l,g-1,f,g-1);M&&t.push(M)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ql(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(fc.fromBufferAttribute(a,s),pc.fromBufferAttribute(a,r),t.distanceSqToSegment(fc,pc,td,Qm)>n)return;td.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(td);if(!(c<e.near||c>e.far))return{distance:c,point:Qm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var eg=new F,tg=new F,Mo=class extends ys{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)eg.fromBufferAttribute(t,s),tg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+eg.distanceTo(tg);e.setAttribute("lineDistance",new zt(n,1))}else rt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ga=class extends Yn{constructor(e=[],t=xr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},_a=class extends Yn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var vs=class extends Yn{constructor(e,t,n=Oi,s,r,o,a=Rn,l=Rn,c,h=_s,u=1){if(h!==_s&&h!==Ms)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new go(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},xa=class extends vs{constructor(e,t=Oi,n=xr,s,r,o=Rn,a=Rn,l,c=_s){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ya=class extends Yn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Jn=class i extends en{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new zt(c,3)),this.setAttribute("normal",new zt(h,3)),this.setAttribute("uv",new zt(u,2));function g(M,m,p,b,C,v,R,E,_,T,B){let N=v/_,D=R/T,k=v/2,W=R/2,L=E/2,H=_+1,q=T+1,V=0,ce=0,Y=new F;for(let j=0;j<q;j++){let ie=j*D-W;for(let pe=0;pe<H;pe++){let he=pe*N-k;Y[M]=he*b,Y[m]=ie*C,Y[p]=L,c.push(Y.x,Y.y,Y.z),Y[M]=0,Y[m]=0,Y[p]=E>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(pe/_),u.push(1-j/T),V+=1}}for(let j=0;j<T;j++)for(let ie=0;ie<_;ie++){let pe=d+ie+H*j,he=d+ie+H*(j+1),ee=d+(ie+1)+H*(j+1),ge=d+(ie+1)+H*j;l.push(pe,he,ge),l.push(he,ee,ge),ce+=6}a.addGroup(f,ce,B),f+=ce,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var va=class i extends en{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],g=0,M=[],m=n/2,p=0;b(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(h),this.setAttribute("position",new zt(u,3)),this.setAttribute("normal",new zt(d,3)),this.setAttribute("uv",new zt(f,2));function b(){let v=new F,R=new F,E=0,_=(t-e)/n;for(let T=0;T<=r;T++){let B=[],N=T/r,D=N*(t-e)+e;for(let k=0;k<=s;k++){let W=k/s,L=W*l+a,H=Math.sin(L),q=Math.cos(L);R.x=D*H,R.y=-N*n+m,R.z=D*q,u.push(R.x,R.y,R.z),v.set(H,_,q).normalize(),d.push(v.x,v.y,v.z),f.push(W,1-N),B.push(g++)}M.push(B)}for(let T=0;T<s;T++)for(let B=0;B<r;B++){let N=M[B][T],D=M[B+1][T],k=M[B+1][T+1],W=M[B][T+1];(e>0||B!==0)&&(h.push(N,D,W),E+=3),(t>0||B!==r-1)&&(h.push(D,k,W),E+=3)}c.addGroup(p,E,0),p+=E}function C(v){let R=g,E=new Xe,_=new F,T=0,B=v===!0?e:t,N=v===!0?1:-1;for(let k=1;k<=s;k++)u.push(0,m*N,0),d.push(0,N,0),f.push(.5,.5),g++;let D=g;for(let k=0;k<=s;k++){let L=k/s*l+a,H=Math.cos(L),q=Math.sin(L);_.x=B*q,_.y=m*N,_.z=B*H,u.push(_.x,_.y,_.z),d.push(0,N,0),E.x=H*.5+.5,E.y=q*.5*N+.5,f.push(E.x,E.y),g++}for(let k=0;k<s;k++){let W=R+k,L=D+k;v===!0?h.push(L,L+1,W):h.push(L+1,L,W),T+=3}c.addGroup(p,T,v===!0?1:2),p+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var fr=class i extends en{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],M=[],m=[];for(let p=0;p<h;p++){let b=p*d-o;for(let C=0;C<c;C++){let v=C*u-r;g.push(v,-b,0),M.push(0,0,1),m.push(C/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let b=0;b<a;b++){let C=b+c*p,v=b+c*(p+1),R=b+1+c*(p+1),E=b+1+c*p;f.push(C,v,E),f.push(v,R,E)}this.setIndex(f),this.setAttribute("position",new zt(g,3)),this.setAttribute("normal",new zt(M,3)),this.setAttribute("uv",new zt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var ba=class i extends en{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new F,d=new F,f=[],g=[],M=[],m=[];for(let p=0;p<=n;p++){let b=[],C=p/n,v=o+C*a,R=e*Math.cos(v),E=Math.sqrt(e*e-R*R),_=0;p===0&&o===0?_=.5/t:p===n&&l===Math.PI&&(_=-.5/t);for(let T=0;T<=t;T++){let B=T/t,N=s+B*r;u.x=-E*Math.cos(N),u.y=R,u.z=E*Math.sin(N),g.push(u.x,u.y,u.z),d.copy(u).normalize(),M.push(d.x,d.y,d.z),m.push(B+_,1-C),b.push(c++)}h.push(b)}for(let p=0;p<n;p++)for(let b=0;b<t;b++){let C=h[p][b+1],v=h[p][b],R=h[p+1][b],E=h[p+1][b+1];(p!==0||o>0)&&f.push(C,v,E),(p!==n-1||l<Math.PI)&&f.push(v,R,E)}this.setIndex(f),this.setAttribute("position",new zt(g,3)),this.setAttribute("normal",new zt(M,3)),this.setAttribute("uv",new zt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var pr=class i extends en{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new F,f=new F,g=new F;for(let M=0;M<=n;M++){let m=o+M/n*a;for(let p=0;p<=s;p++){let b=p/s*r;f.x=(e+t*Math.cos(m))*Math.cos(b),f.y=(e+t*Math.cos(m))*Math.sin(b),f.z=t*Math.sin(m),c.push(f.x,f.y,f.z),d.x=e*Math.cos(b),d.y=e*Math.sin(b),g.subVectors(f,d).normalize(),h.push(g.x,g.y,g.z),u.push(p/s),u.push(M/n)}}for(let M=1;M<=n;M++)for(let m=1;m<=s;m++){let p=(s+1)*M+m-1,b=(s+1)*(M-1)+m-1,C=(s+1)*(M-1)+m,v=(s+1)*M+m;l.push(p,b,v),l.push(b,C,v)}this.setIndex(l),this.setAttribute("position",new zt(c,3)),this.setAttribute("normal",new zt(h,3)),this.setAttribute("uv",new zt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function vr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(ng(s))s.isRenderTargetTexture?(rt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(ng(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function On(i){let e={};for(let t=0;t<i.length;t++){let n=vr(i[t]);for(let s in n)e[s]=n[s]}return e}function ng(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function _v(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Gd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:At.workingColorSpace}var Jg={clone:vr,merge:On},xv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,yv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Qi=class extends Ki{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=xv,this.fragmentShader=yv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=vr(e.uniforms),this.uniformsGroups=_v(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new nt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Xe().fromArray(s.value);break;case"v3":this.uniforms[n].value=new F().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Rt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new at().fromArray(s.value);break;case"m4":this.uniforms[n].value=new gt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},mc=class extends Qi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ni=class extends Ki{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=gh,this.normalScale=new Xe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xs,this.combine=Pc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},gc=class extends Ki{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Og,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},_c=class extends Ki{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ao(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Yl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Vs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},xc=class extends Vs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:sd,endingEnd:sd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case rd:r=e,a=2*t-n;break;case od:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case rd:o=e,l=2*n-t;break;case od:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),M=g*g,m=M*g,p=-d*m+2*d*M-d*g,b=(1+d)*m+(-1.5-2*d)*M+(-.5+d)*g+1,C=(-1-f)*m+(1.5+f)*M+.5*g,v=f*m-f*M;for(let R=0;R!==a;++R)r[R]=p*o[h+R]+b*o[c+R]+C*o[l+R]+v*o[u+R];return r}},yc=class extends Vs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},vc=class extends Vs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},bc=class extends Vs{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),M=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*M+o[l+m]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let M=o[c+g],m=o[l+g],p=f*d+g*2,b=u[p],C=u[p+1],v=e*d+g*2,R=h[v],E=h[v+1],_=bv(n,t,b,R,s);r[g]=Kg(_,M,C,E,m)}return r}};function Kg(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function vv(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function bv(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Kg(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=vv(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ui=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ao(t,this.TimeBufferType),this.values=ao(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:ao(e.times,Array),values:ao(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Yl(e.settings)&&(n.settings={inTangents:ao(e.settings.inTangents,Array),outTangents:ao(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new vc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new yc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new xc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new bc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case aa:t=this.InterpolantFactoryMethodDiscrete;break;case ac:t=this.InterpolantFactoryMethodLinear;break;case Jl:t=this.InterpolantFactoryMethodSmooth;break;case id:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return rt("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return aa;case this.InterpolantFactoryMethodLinear:return ac;case this.InterpolantFactoryMethodSmooth:return Jl;case this.InterpolantFactoryMethodBezier:return id}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Yl(this.settings)&&(ig(this.settings.inTangents,e),ig(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Yl(this.settings)&&(sg(this.settings.inTangents,e),sg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ht("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ht("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ht("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){ht("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Fy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ht("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Jl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let M=t[u+g];if(M!==t[d+g]||M!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Yl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function ig(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function sg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ui.prototype.ValueTypeName="";ui.prototype.TimeBufferType=Float32Array;ui.prototype.ValueBufferType=Float32Array;ui.prototype.DefaultInterpolation=ac;var Ws=class extends ui{constructor(e,t,n){super(e,t,n)}};Ws.prototype.ValueTypeName="bool";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=aa;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Mc=class extends ui{constructor(e,t,n,s){super(e,t,n,s)}};Mc.prototype.ValueTypeName="color";var Sc=class extends ui{constructor(e,t,n,s){super(e,t,n,s)}};Sc.prototype.ValueTypeName="number";var wc=class extends Vs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)li.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ma=class extends ui{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new wc(this.times,this.values,this.getValueSize(),e)}};Ma.prototype.ValueTypeName="quaternion";Ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends ui{constructor(e,t,n){super(e,t,n)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=aa;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends ui{constructor(e,t,n,s){super(e,t,n,s)}};Tc.prototype.ValueTypeName="vector";var Ac=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},jg=new Ac,Ec=class{constructor(e){this.manager=e!==void 0?e:jg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ec.DEFAULT_MATERIAL_NAME="__DEFAULT";var So=class extends yn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new nt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Sa=class extends So{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(yn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new nt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},nd=new gt,rg=new F,og=new F,Cc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Xe(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new gt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ji,this._frameExtents=new Xe(1,1),this._viewportCount=1,this._viewports=[new Rt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;rg.setFromMatrixPosition(e.matrixWorld),t.position.copy(rg),og.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(og),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){nd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(nd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===fo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(nd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},$l=new F,Zl=new li,Zi=new F,mr=class extends yn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new gt,this.projectionMatrix=new gt,this.projectionMatrixInverse=new gt,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose($l,Zl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose($l,Zl,Zi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose($l,Zl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose($l,Zl,Zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},zs=new F,ag=new Xe,lg=new Xe,Xn=class extends mr{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=mo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ra*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return mo*2*Math.atan(Math.tan(ra*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){zs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(zs.x,zs.y).multiplyScalar(-e/zs.z),zs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(zs.x,zs.y).multiplyScalar(-e/zs.z)}getViewSize(e,t){return this.getViewBounds(e,ag,lg),t.subVectors(lg,ag)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ra*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ui=class extends mr{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},ad=class extends Cc{constructor(){super(new Ui(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wa=class extends So{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(yn.DEFAULT_UP),this.updateMatrix(),this.target=new yn,this.shadow=new ad}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ta=class extends So{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var lo=-90,co=1,wo=class extends yn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(lo,co,e,t);s.layers=this.layers,this.add(s);let r=new Xn(lo,co,e,t);r.layers=this.layers,this.add(r);let o=new Xn(lo,co,e,t);o.layers=this.layers,this.add(o);let a=new Xn(lo,co,e,t);a.layers=this.layers,this.add(a);let l=new Xn(lo,co,e,t);l.layers=this.layers,this.add(l);let c=new Xn(lo,co,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===vi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===fo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let M=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=M,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Rc=class extends Xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Hd="\\[\\]\\.:\\/",Mv=new RegExp("["+Hd+"]","g"),Vd="[^"+Hd+"]",Sv="[^"+Hd.replace("\\.","")+"]",wv=/((?:WC+[\/:])*)/.source.replace("WC",Vd),Tv=/(WCOD+)?/.source.replace("WCOD",Sv),Av=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Vd),Ev=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Vd),Cv=new RegExp("^"+wv+Tv+Av+Ev+"$"),Rv=["material","materials","bones","map"],ld=class{constructor(e,t,n){let s=n||Kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Mv,"")}static parseTrackName(e){let t=Cv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Rv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){rt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ht("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ht("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ht("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ht("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ht("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;ht("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Kt.Composite=ld;Kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Kt.prototype.GetterByBindingType=[Kt.prototype._getValue_direct,Kt.prototype._getValue_array,Kt.prototype._getValue_arrayElement,Kt.prototype._getValue_toArray];Kt.prototype.SetterByBindingTypeAndVersioning=[[Kt.prototype._setValue_direct,Kt.prototype._setValue_direct_setNeedsUpdate,Kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_array,Kt.prototype._setValue_array_setNeedsUpdate,Kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_arrayElement,Kt.prototype._setValue_arrayElement_setNeedsUpdate,Kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_fromArray,Kt.prototype._setValue_fromArray_setNeedsUpdate,Kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var c1=new Float32Array(1);var cg=new gt,Aa=class{constructor(e,t,n=0,s=1/0){this.ray=new Gs(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new _o,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ht("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return cg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(cg),this}intersectObject(e,t=!0,n=[]){return cd(e,this,n,t),n.sort(hg),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)cd(e[s],this,n,t);return n.sort(hg),n}};function hg(i,e){return i.distance-e.distance}function cd(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)cd(r[o],e,t,!0)}}var To=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(Mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var hd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}},ug=new Xe,Ao=class{constructor(e=new Xe(1/0,1/0),t=new Xe(-1/0,-1/0)){this.isBox2=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ug.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=1/0,this.max.x=this.max.y=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y}getCenter(e){return this.isEmpty()?e.set(0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ug).distanceTo(e)}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}};var Ea=class extends Mo{constructor(e=10,t=10,n=4473924,s=8947848){n=new nt(n),s=new nt(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,g=-a;d<=t;d++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let M=d===r?n:s;M.toArray(c,f),f+=3,M.toArray(c,f),f+=3,M.toArray(c,f),f+=3,M.toArray(c,f),f+=3}let h=new en;h.setAttribute("position",new zt(l,3)),h.setAttribute("color",new zt(c,3));let u=new Hs({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ca=class extends Li{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Wd(i,e,t,n){let s=Pv(n);switch(t){case Rd:return i*e;case Id:return i*e/s.components*s.byteLength;case Fc:return i*e/s.components*s.byteLength;case Zs:return i*e*2/s.components*s.byteLength;case Bc:return i*e*2/s.components*s.byteLength;case Pd:return i*e*3/s.components*s.byteLength;case ki:return i*e*4/s.components*s.byteLength;case kc:return i*e*4/s.components*s.byteLength;case Ia:case La:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Da:case Na:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Gc:case Vc:return Math.max(i,16)*Math.max(e,8)/4;case zc:case Hc:return Math.max(i,8)*Math.max(e,8)/2;case Wc:case Xc:case Yc:case $c:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case qc:case Ua:case Zc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Kc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case jc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Qc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case eh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case th:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case nh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ih:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case sh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case rh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case oh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ah:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case lh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case ch:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case hh:case uh:case dh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case fh:case ph:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Oa:case mh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Pv(i){switch(i){case Kn:case Td:return{byteLength:1,components:1};case Po:case Ad:case Bi:return{byteLength:2,components:1};case Uc:case Oc:return{byteLength:2,components:4};case Oi:case Nc:case Fi:return{byteLength:4,components:1};case Ed:case Cd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?rt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function v0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Ov(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],M=u[f];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++d,u[d]=M)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let M=u[f];i.bufferSubData(c,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Fv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Bv=`#ifdef USE_ALPHAHASH
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
#endif`,kv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,zv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Gv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Hv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Vv=`#ifdef USE_AOMAP
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
#endif`,Wv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Xv=`#ifdef USE_BATCHING
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
#endif`,qv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Yv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$v=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Zv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Jv="",Kv=`#ifdef USE_BUMPMAP
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
#endif`,jv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Qv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,eb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,tb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,nb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ib=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,sb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,rb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ob=`#define PI 3.141592653589793
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
} // validated`,ab=`vec3 transformedNormal = objectNormal;
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
#endif`,lb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,cb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,hb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ub=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,db="gl_FragColor = linearToOutputTexel( gl_FragColor );",fb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,pb=`#ifdef USE_ENVMAP
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
#endif`,mb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,gb=`#ifdef USE_ENVMAP
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
#endif`,_b=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,xb=`#ifdef USE_ENVMAP
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
#endif`,yb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,vb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,bb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Mb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Sb="",wb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Tb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ab=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Eb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Cb=`#ifdef USE_ENVMAP
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
#endif`,Rb="",Pb="",Ib="",Lb="",Db="",Nb="",Ub=`
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
#endif`,Ob=`#if defined( RE_IndirectDiffuse )
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
#endif`,Fb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Bb=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,kb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,zb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Gb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Hb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Vb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Wb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Xb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,qb=`#if defined( USE_POINTS_UV )
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
#endif`,Yb="",$b="",Zb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Jb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Kb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jb=`#ifdef USE_MORPHTARGETS
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
#endif`,Qb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,tM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,nM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,rM=`#ifdef USE_NORMALMAP
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
#endif`,oM="",aM="",lM="",cM="",hM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,uM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,dM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,fM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,pM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,mM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,gM="",_M="",xM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,yM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,vM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,bM=`float getShadowMask() {
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
}`,MM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,SM=`#ifdef USE_SKINNING
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
#endif`,wM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,TM=`#ifdef USE_SKINNING
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
#endif`,AM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,EM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,CM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,RM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,PM="",IM="",LM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,DM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,NM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,UM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,OM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,FM=`uniform sampler2D t2D;
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
}`,BM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kM=`uniform float backgroundBlurriness;
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
}`,zM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,GM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,HM=`#include <common>
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
}`,VM=`#if DEPTH_PACKING == 3200
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
}`,WM=`#define DISTANCE
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
}`,XM=`#define DISTANCE
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
}`,qM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,YM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$M=`uniform float scale;
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
}`,ZM=`uniform vec3 diffuse;
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
}`,JM=`#include <common>
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
}`,KM=`uniform vec3 diffuse;
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
}`,jM=`#define LAMBERT
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
}`,QM=`#define LAMBERT
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
}`,eS=`#define MATCAP
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
}`,tS=`#define MATCAP
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
}`,nS=`#define NORMAL
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
}`,iS=`#define NORMAL
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
}`,sS=`#define PHONG
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
}`,rS=`#define PHONG
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
}`,oS=`#define STANDARD
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
}`,aS=`#define STANDARD
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
}`,lS=`#define TOON
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
}`,cS=`#define TOON
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
}`,hS=`uniform float size;
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
}`,uS=`uniform vec3 diffuse;
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
}`,dS=`#include <common>
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
}`,fS=`uniform vec3 color;
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
}`,pS=`uniform float rotation;
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
}`,mS=`uniform vec3 diffuse;
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
}`,xt={alphahash_fragment:Fv,alphahash_pars_fragment:Bv,alphamap_fragment:kv,alphamap_pars_fragment:zv,alphatest_fragment:Gv,alphatest_pars_fragment:Hv,aomap_fragment:Vv,aomap_pars_fragment:Wv,batching_pars_vertex:Xv,batching_vertex:qv,begin_vertex:Yv,beginnormal_vertex:$v,bsdfs:Zv,iridescence_fragment:Jv,bumpmap_pars_fragment:Kv,clipping_planes_fragment:jv,clipping_planes_pars_fragment:Qv,clipping_planes_pars_vertex:eb,clipping_planes_vertex:tb,color_fragment:nb,color_pars_fragment:ib,color_pars_vertex:sb,color_vertex:rb,common:ob,defaultnormal_vertex:ab,displacementmap_pars_vertex:lb,displacementmap_vertex:cb,emissivemap_fragment:hb,emissivemap_pars_fragment:ub,colorspace_fragment:db,colorspace_pars_fragment:fb,envmap_fragment:pb,envmap_common_pars_fragment:mb,envmap_pars_fragment:gb,envmap_pars_vertex:_b,envmap_physical_pars_fragment:Cb,envmap_vertex:xb,fog_vertex:yb,fog_pars_vertex:vb,fog_fragment:bb,fog_pars_fragment:Mb,gradientmap_pars_fragment:Sb,lightmap_pars_fragment:wb,lights_lambert_fragment:Tb,lights_lambert_pars_fragment:Ab,lights_pars_begin:Eb,lights_toon_fragment:Rb,lights_toon_pars_fragment:Pb,lights_phong_fragment:Ib,lights_phong_pars_fragment:Lb,lights_physical_fragment:Db,lights_physical_pars_fragment:Nb,lights_fragment_begin:Ub,lights_fragment_maps:Ob,lights_fragment_end:Fb,lightprobes_pars_fragment:Bb,logdepthbuf_fragment:kb,logdepthbuf_pars_fragment:zb,logdepthbuf_pars_vertex:Gb,logdepthbuf_vertex:Hb,map_fragment:Vb,map_pars_fragment:Wb,map_particle_fragment:Xb,map_particle_pars_fragment:qb,metalnessmap_fragment:Yb,metalnessmap_pars_fragment:$b,morphinstance_vertex:Zb,morphcolor_vertex:Jb,morphnormal_vertex:Kb,morphtarget_pars_vertex:jb,morphtarget_vertex:Qb,normal_fragment_begin:eM,normal_fragment_maps:tM,normal_pars_fragment:nM,normal_pars_vertex:iM,normal_vertex:sM,normalmap_pars_fragment:rM,clearcoat_normal_fragment_begin:oM,clearcoat_normal_fragment_maps:aM,clearcoat_pars_fragment:lM,iridescence_pars_fragment:cM,opaque_fragment:hM,packing:uM,premultiplied_alpha_fragment:dM,project_vertex:fM,dithering_fragment:pM,dithering_pars_fragment:mM,roughnessmap_fragment:gM,roughnessmap_pars_fragment:_M,shadowmap_pars_fragment:xM,shadowmap_pars_vertex:yM,shadowmap_vertex:vM,shadowmask_pars_fragment:bM,skinbase_vertex:MM,skinning_pars_vertex:SM,skinning_vertex:wM,skinnormal_vertex:TM,specularmap_fragment:AM,specularmap_pars_fragment:EM,tonemapping_fragment:CM,tonemapping_pars_fragment:RM,transmission_fragment:PM,transmission_pars_fragment:IM,uv_pars_fragment:LM,uv_pars_vertex:DM,uv_vertex:NM,worldpos_vertex:UM,background_vert:OM,background_frag:FM,backgroundCube_vert:BM,backgroundCube_frag:kM,cube_vert:zM,cube_frag:GM,depth_vert:HM,depth_frag:VM,distance_vert:WM,distance_frag:XM,equirect_vert:qM,equirect_frag:YM,linedashed_vert:$M,linedashed_frag:ZM,meshbasic_vert:JM,meshbasic_frag:KM,meshlambert_vert:jM,meshlambert_frag:QM,meshmatcap_vert:eS,meshmatcap_frag:tS,meshnormal_vert:nS,meshnormal_frag:iS,meshphong_vert:sS,meshphong_frag:rS,meshphysical_vert:oS,meshphysical_frag:aS,meshtoon_vert:lS,meshtoon_frag:cS,points_vert:hS,points_frag:uS,shadow_vert:dS,shadow_frag:fS,sprite_vert:pS,sprite_frag:mS},ke={common:{diffuse:{value:new nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new at},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new at}},envmap:{envMap:{value:null},envMapRotation:{value:new at},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new at}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new at}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new at},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new at},normalScale:{value:new Xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new at},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new at}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new at}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new at}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0},uvTransform:{value:new at}},sprite:{diffuse:{value:new nt(16777215)},opacity:{value:1},center:{value:new Xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new at},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0}}},ns={basic:{uniforms:On([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.fog]),vertexShader:xt.meshbasic_vert,fragmentShader:xt.meshbasic_frag},lambert:{uniforms:On([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,ke.lights,{emissive:{value:new nt(0)},envMapIntensity:{value:1}}]),vertexShader:xt.meshlambert_vert,fragmentShader:xt.meshlambert_frag},phong:{uniforms:On([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,ke.lights,{emissive:{value:new nt(0)},specular:{value:new nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:xt.meshphong_vert,fragmentShader:xt.meshphong_frag},standard:{uniforms:On([ke.common,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.roughnessmap,ke.metalnessmap,ke.fog,ke.lights,{emissive:{value:new nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:xt.meshphysical_vert,fragmentShader:xt.meshphysical_frag},toon:{uniforms:On([ke.common,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.gradientmap,ke.fog,ke.lights,{emissive:{value:new nt(0)}}]),vertexShader:xt.meshtoon_vert,fragmentShader:xt.meshtoon_frag},matcap:{uniforms:On([ke.common,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,{matcap:{value:null}}]),vertexShader:xt.meshmatcap_vert,fragmentShader:xt.meshmatcap_frag},points:{uniforms:On([ke.points,ke.fog]),vertexShader:xt.points_vert,fragmentShader:xt.points_frag},dashed:{uniforms:On([ke.common,ke.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:xt.linedashed_vert,fragmentShader:xt.linedashed_frag},depth:{uniforms:On([ke.common,ke.displacementmap]),vertexShader:xt.depth_vert,fragmentShader:xt.depth_frag},normal:{uniforms:On([ke.common,ke.bumpmap,ke.normalmap,ke.displacementmap,{opacity:{value:1}}]),vertexShader:xt.meshnormal_vert,fragmentShader:xt.meshnormal_frag},sprite:{uniforms:On([ke.sprite,ke.fog]),vertexShader:xt.sprite_vert,fragmentShader:xt.sprite_frag},background:{uniforms:{uvTransform:{value:new at},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:xt.background_vert,fragmentShader:xt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new at}},vertexShader:xt.backgroundCube_vert,fragmentShader:xt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:xt.cube_vert,fragmentShader:xt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:xt.equirect_vert,fragmentShader:xt.equirect_frag},distance:{uniforms:On([ke.common,ke.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:xt.distance_vert,fragmentShader:xt.distance_frag},shadow:{uniforms:On([ke.lights,ke.fog,{color:{value:new nt(0)},opacity:{value:1}}]),vertexShader:xt.shadow_vert,fragmentShader:xt.shadow_frag}};ns.physical={uniforms:On([ns.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new at},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new at},clearcoatNormalScale:{value:new Xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new at},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new at},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new at},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new at},sheen:{value:0},sheenColor:{value:new nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new at},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new at},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new at},transmissionSamplerSize:{value:new Xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new at},attenuationDistance:{value:0},attenuationColor:{value:new nt(0)},specularColor:{value:new nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new at},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new at},anisotropyVector:{value:new Xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new at}}]),vertexShader:xt.meshphysical_vert,fragmentShader:xt.meshphysical_frag};var yh={r:0,b:0,g:0},gS=new gt,b0=new at;b0.set(-1,0,0,0,1,0,0,0,1);function _S(i,e,t,n,s,r){let o=new nt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(b){let C=b.isScene===!0?b.background:null;if(C&&C.isTexture){let v=b.backgroundBlurriness>0;C=e.get(C,v)}return C}function g(b){let C=!1,v=f(b);v===null?m(o,a):v&&v.isColor&&(m(v,1),C=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function M(b,C){let v=f(C);v&&v.isCubeTexture?(c===void 0&&(c=new tn(new Jn(1,1,1),new Qi({name:"BackgroundCubeMaterial",uniforms:vr(ns.backgroundCube.uniforms),vertexShader:ns.backgroundCube.vertexShader,fragmentShader:ns.backgroundCube.fragmentShader,side:$n,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(gS.makeRotationFromEuler(C.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(b0),c.material.toneMapped=At.getTransfer(v.colorSpace)!==Ut,(h!==v||u!==v.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new tn(new fr(2,2),new Qi({name:"BackgroundMaterial",uniforms:vr(ns.background.uniforms),vertexShader:ns.background.vertexShader,fragmentShader:ns.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=At.getTransfer(v.colorSpace)!==Ut,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||u!==v.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function m(b,C){b.getRGB(yh,Gd(i)),t.buffers.color.setClear(yh.r,yh.g,yh.b,C,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,C=1){o.set(b),a=C,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,m(o,a)},render:g,addToRenderList:M,dispose:p}}function xS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,k,W,L,H){let q=!1,V=u(D,L,W,k);r!==V&&(r=V,c(r.object)),q=f(D,L,W,H),q&&g(D,L,W,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,v(D,k,W,L),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,k,W,L){let H=L.wireframe===!0,q=n[k.id];q===void 0&&(q={},n[k.id]=q);let V=D.isInstancedMesh===!0?D.id:0,ce=q[V];ce===void 0&&(ce={},q[V]=ce);let Y=ce[W.id];Y===void 0&&(Y={},ce[W.id]=Y);let j=Y[H];return j===void 0&&(j=d(l()),Y[H]=j),j}function d(D){let k=[],W=[],L=[];for(let H=0;H<t;H++)k[H]=0,W[H]=0,L[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:W,attributeDivisors:L,object:D,attributes:{},index:null}}function f(D,k,W,L){let H=r.attributes,q=k.attributes,V=0,ce=W.getAttributes();for(let Y in ce)if(ce[Y].location>=0){let ie=H[Y],pe=q[Y];if(pe===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(pe=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(pe=D.instanceColor)),ie===void 0||ie.attribute!==pe||pe&&ie.data!==pe.data)return!0;V++}return r.attributesNum!==V||r.index!==L}function g(D,k,W,L){let H={},q=k.attributes,V=0,ce=W.getAttributes();for(let Y in ce)if(ce[Y].location>=0){let ie=q[Y];ie===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let pe={};pe.attribute=ie,ie&&ie.data&&(pe.data=ie.data),H[Y]=pe,V++}r.attributes=H,r.attributesNum=V,r.index=L}function M(){let D=r.newAttributes;for(let k=0,W=D.length;k<W;k++)D[k]=0}function m(D){p(D,0)}function p(D,k){let W=r.newAttributes,L=r.enabledAttributes,H=r.attributeDivisors;W[D]=1,L[D]===0&&(i.enableVertexAttribArray(D),L[D]=1),H[D]!==k&&(i.vertexAttribDivisor(D,k),H[D]=k)}function b(){let D=r.newAttributes,k=r.enabledAttributes;for(let W=0,L=k.length;W<L;W++)k[W]!==D[W]&&(i.disableVertexAttribArray(W),k[W]=0)}function C(D,k,W,L,H,q,V){V===!0?i.vertexAttribIPointer(D,k,W,H,q):i.vertexAttribPointer(D,k,W,L,H,q)}function v(D,k,W,L){M();let H=L.attributes,q=W.getAttributes(),V=k.defaultAttributeValues;for(let ce in q){let Y=q[ce];if(Y.location>=0){let j=H[ce];if(j===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let ie=j.normalized,pe=j.itemSize,he=e.get(j);if(he===void 0)continue;let ee=he.buffer,ge=he.type,Me=he.bytesPerElement,Le=ge===i.INT||ge===i.UNSIGNED_INT||j.gpuType===Nc;if(j.isInterleavedBufferAttribute){let Ee=j.data,je=Ee.isInterleavedBuffer===!0?Ee.stride:Ee.itemSize,ut=j.offset;if(Ee.isInstancedInterleavedBuffer||Ee.isInstancedBufferAttribute){for(let Je=0;Je<Y.locationSize;Je++)p(Y.location+Je,Ee.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Ee.meshPerAttribute*Ee.count)}else for(let Je=0;Je<Y.locationSize;Je++)m(Y.location+Je);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Je=0;Je<Y.locationSize;Je++)C(Y.location+Je,pe/Y.locationSize,ge,ie,je*Me,(ut+pe/Y.locationSize*Je)*Me,Le)}else{if(j.isInstancedBufferAttribute){for(let Ee=0;Ee<Y.locationSize;Ee++)p(Y.location+Ee,j.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Ee=0;Ee<Y.locationSize;Ee++)m(Y.location+Ee);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Ee=0;Ee<Y.locationSize;Ee++)C(Y.location+Ee,pe/Y.locationSize,ge,ie,pe*Me,pe/Y.locationSize*Ee*Me,Le)}}else if(V!==void 0){let ie=V[ce];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Y.location,ie);break;case 3:i.vertexAttrib3fv(Y.location,ie);break;case 4:i.vertexAttrib4fv(Y.location,ie);break;default:i.vertexAttrib1fv(Y.location,ie)}}}}b()}function R(){B();for(let D in n){let k=n[D];for(let W in k){let L=k[W];for(let H in L){let q=L[H];for(let V in q)h(q[V].object),delete q[V];delete L[H]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let k=n[D.id];for(let W in k){let L=k[W];for(let H in L){let q=L[H];for(let V in q)h(q[V].object),delete q[V];delete L[H]}}delete n[D.id]}function _(D){for(let k in n){let W=n[k];for(let L in W){let H=W[L];if(H[D.id]===void 0)continue;let q=H[D.id];for(let V in q)h(q[V].object),delete q[V];delete H[D.id]}}}function T(D){for(let k in n){let W=n[k],L=D.isInstancedMesh===!0?D.id:0,H=W[L];if(H!==void 0){for(let q in H){let V=H[q];for(let ce in V)h(V[ce].object),delete V[ce];delete H[q]}delete W[L],Object.keys(W).length===0&&delete n[k]}}}function B(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:M,enableAttribute:m,disableUnusedAttributes:b}}function yS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function vS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ki&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===Bi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Kn&&_!==Fi&&!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(rt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&rt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&rt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:b,maxVaryings:C,maxFragmentUniforms:v,maxSamples:R,samples:E}}function bS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Wn,a=new at,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,M=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let b=r?0:n,C=b*4,v=p.clippingState||null;l.value=v,v=h(g,d,C,f);for(let R=0;R!==C;++R)v[R]=t[R];p.clippingState=v,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let M=u!==null?u.length:0,m=null;if(M!==0){if(m=l.value,g!==!0||m===null){let p=f+M*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(m===null||m.length<p)&&(m=new Float32Array(p));for(let C=0,v=f;C!==M;++C,v+=4)o.copy(u[C]).applyMatrix4(b,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,m}}var ka=class extends ci{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ga(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Jn(5,5,5),r=new Qi({name:"CubemapFromEquirect",uniforms:vr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:$n,blending:gr});r.uniforms.tEquirect.value=t;let o=new tn(s,r),a=t.minFilter;return t.minFilter===bs&&(t.minFilter=qn),new wo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Qg=256,MS=3,SS=20,M0=256,S0=16,wS=3,TS=new F,AS=new nt,bh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new wo(1,10,null),this._boxMesh=new tn(new Jn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=TS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,M=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,M===null&&(e.background=l.getClearColor(AS));let m=new wo(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=M,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=n0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=t0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Qg,Bd(e))}_fromTexture(e,t){e.mapping===xr||e.mapping===Ro?this._setSize(e.image.length===0?Qg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=e0(e,!1,!1),n=Math.log2(e)-MS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=e0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===xr||e.mapping===Ro?(this._cubemapMaterial===null&&(this._cubemapMaterial=n0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=t0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ES(),this._integrationMaterial=CS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/S0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-wS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(M0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=RS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function e0(i,e,t){return new ka(i,{minFilter:bs,generateMipmaps:e,type:Bi,colorSpace:la,depthBuffer:t})}function Ga(i,e,t){return new Qi({name:i,uniforms:e,vertexShader:xt.cube_vert,fragmentShader:t,side:$n,blending:gr,depthTest:!1,depthWrite:!1})}function ES(){return Ga("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${M0}u

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
	`)}function CS(){return Ga("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:S0}},`

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
	`)}function RS(){return Ga("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${SS}
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
	`)}function t0(){return Ga("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function n0(){return Ga("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function PS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Ic||f===Lc)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let M=new ka(g.height);return M.fromEquirectangularTexture(i,d),e.set(d,M),d.addEventListener("dispose",c),a(M.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Ic||f===Lc,M=f===xr||f===Ro;if(g||M){let m=t.get(d),p=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return n===null&&(n=new bh(i)),m=g?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let b=d.image;return g&&b&&b.height>0||M&&b&&l(b)?(n===null&&(n=new bh(i)),m=g?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Ic?d.mapping=xr:f===Lc&&(d.mapping=Ro),d}function l(d){let f=0,g=6;for(let M=0;M<g;M++)d[M]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function IS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&sa("WebGLRenderer: "+n+" extension not supported."),s}}}function LS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let M=r.get(g);M&&(e.remove(M),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,M){return s[M.id]!==void 0||(M.addEventListener("dispose",a),s[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function h(g){let M=g.attributes;for(let m in M)e.update(M[m],i.ARRAY_BUFFER)}function u(g){let M=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let b=M!==null?M.array.length:m.array.length/3-1,C=m.count>=65535?pa:fa,v=new C(Math.ceil(b/3)*6,1),R=v.array;if(M!==null){let _=M.array;p=M.version;for(let T=0,B=0;T<b;T+=3){let N=_[T+0],D=_[T+1],k=_[T+2];R[B++]=N,R[B++]=D,R[B++]=D,R[B++]=k,R[B++]=k,R[B++]=N}}else{p=m.version;for(let _=0,T=0;_<b;_+=3){let B=_+0,N=_+1,D=_+2;R[T++]=B,R[T++]=N,R[T++]=N,R[T++]=D,R[T++]=D,R[T++]=B}}v.version=p;let E=r.get(g);E&&e.remove(E),r.set(g,v)}function d(g){let M=r.get(g);if(M){let m=g.index;m!==null&&M.version<m.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let M=s[g].deref();M!==void 0&&l(M)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function DS(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let M=0;for(let m=0;m<f;m++)M+=d[m];t.update(M,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function NS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:ht("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function US(i,e,t){let n=new WeakMap,s=new Rt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let B=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",B)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],C=0;f===!0&&(C=1),g===!0&&(C=2),M===!0&&(C=3);let v=a.attributes.position.count*C,R=1;v>e.maxTextureSize&&(R=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let E=new Float32Array(v*R*4*u),_=new da(E,v,R,u);_.type=Fi,_.needsUpdate=!0;let T=C*4;for(let N=0;N<u;N++){let D=m[N],k=p[N],W=b[N],L=v*R*4*N;for(let H=0;H<D.count;H++){let q=H*T;f===!0&&(s.fromBufferAttribute(D,H),E[L+q+0]=s.x,E[L+q+1]=s.y,E[L+q+2]=s.z,E[L+q+3]=0),g===!0&&(s.fromBufferAttribute(k,H),E[L+q+4]=s.x,E[L+q+5]=s.y,E[L+q+6]=s.z,E[L+q+7]=0),M===!0&&(s.fromBufferAttribute(W,H),E[L+q+8]=s.x,E[L+q+9]=s.y,E[L+q+10]=s.z,E[L+q+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new Xe(v,R)},n.set(a,d),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let M=0;M<c.length;M++)f+=c[M];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function OS(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var FS={[_d]:"LINEAR_TONE_MAPPING",[xd]:"REINHARD_TONE_MAPPING",[yd]:"CINEON_TONE_MAPPING",[vd]:"ACES_FILMIC_TONE_MAPPING",[Md]:"AGX_TONE_MAPPING",[Sd]:"NEUTRAL_TONE_MAPPING",[bd]:"CUSTOM_TONE_MAPPING"};function BS(i,e,t,n,s,r){let o=new ci(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new en;h.setAttribute("position",new zt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new zt([0,2,0,0,2,0],2));let u=new mc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new tn(h,u),f=new Ui(-1,1,1,-1,0,1),g=null,M=null,m=!1,p,b=null,C=[],v=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let _=0;_<C.length;_++){let T=C[_];T.setSize&&T.setSize(R,E)}},this.setEffects=function(R){C=R,v=C.length>0&&C[0].isRenderPass===!0;let E=o.width,_=o.height;C.length>0&&a===null&&(a=new ci(E,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}),l=new ci(E,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&C.some(B=>B.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new vs(E,_),r===!0&&(c.format=Ms,c.type=yr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let B=0;B<C.length;B++){let N=C[B];N.setSize&&N.setSize(E,_),T&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,E){if(m||R.toneMapping===es&&C.length===0)return!1;if(b=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return v===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=es,!0},this.hasRenderPass=function(){return v},this.end=function(R,E){R.toneMapping=p,m=!0;let _=o,T=a;for(let B=0;B<C.length;B++){let N=C[B];N.enabled!==!1&&(N.render(R,T,_,E),N.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(g!==R.outputColorSpace||M!==R.toneMapping){g=R.outputColorSpace,M=R.toneMapping,u.defines={},At.getTransfer(g)===Ut&&(u.defines.SRGB_TRANSFER="");let B=FS[M];B&&(u.defines[B]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(b),R.render(d,f),b=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var w0=new Yn,T0=new vs(1,1),A0=new xa(1),E0=new da,C0=new hc,R0=new ga,i0=[],s0=[],r0=new Float32Array(16),o0=new Float32Array(9),a0=new Float32Array(4);function Lo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=i0[s];if(r===void 0&&(r=new Float32Array(s),i0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function vn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function bn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Mh(i,e){let t=s0[e];t===void 0&&(t=new Int32Array(e),s0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function kS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function zS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;i.uniform2fv(this.addr,e),bn(t,e)}}function GS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(vn(t,e))return;i.uniform3fv(this.addr,e),bn(t,e)}}function HS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;i.uniform4fv(this.addr,e),bn(t,e)}}function VS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(vn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),bn(t,e)}else{if(vn(t,n))return;a0.set(n),i.uniformMatrix2fv(this.addr,!1,a0),bn(t,n)}}function WS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(vn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),bn(t,e)}else{if(vn(t,n))return;o0.set(n),i.uniformMatrix3fv(this.addr,!1,o0),bn(t,n)}}function XS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(vn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),bn(t,e)}else{if(vn(t,n))return;r0.set(n),i.uniformMatrix4fv(this.addr,!1,r0),bn(t,n)}}function qS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function YS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;i.uniform2iv(this.addr,e),bn(t,e)}}function $S(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;i.uniform3iv(this.addr,e),bn(t,e)}}function ZS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;i.uniform4iv(this.addr,e),bn(t,e)}}function JS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function KS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;i.uniform2uiv(this.addr,e),bn(t,e)}}function jS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;i.uniform3uiv(this.addr,e),bn(t,e)}}function QS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;i.uniform4uiv(this.addr,e),bn(t,e)}}function Sh(i){return i.version===0&&(i.compareFunction=Nd,i.needsUpdate=!0),i}function ew(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Sh(T0):r=w0,t.setTexture2D(e||r,s)}function tw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||C0,s)}function nw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Sh(A0):r=R0,t.setTextureCube(e||r,s)}function iw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||E0,s)}function sw(i){switch(i){case 5126:return kS;case 35664:return zS;case 35665:return GS;case 35666:return HS;case 35674:return VS;case 35675:return WS;case 35676:return XS;case 5124:case 35670:return qS;case 35667:case 35671:return YS;case 35668:case 35672:return $S;case 35669:case 35673:return ZS;case 5125:return JS;case 36294:return KS;case 36295:return jS;case 36296:return QS;case 35678:case 36198:case 36298:case 36306:case 35682:return ew;case 35679:case 36299:case 36307:return tw;case 35680:case 36300:case 36308:case 36293:return nw;case 36289:case 36303:case 36311:case 36292:return iw}}function rw(i,e){i.uniform1fv(this.addr,e)}function ow(i,e){let t=Lo(e,this.size,2);i.uniform2fv(this.addr,t)}function aw(i,e){let t=Lo(e,this.size,3);i.uniform3fv(this.addr,t)}function lw(i,e){let t=Lo(e,this.size,4);i.uniform4fv(this.addr,t)}function cw(i,e){let t=Lo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function hw(i,e){let t=Lo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function uw(i,e){let t=Lo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function dw(i,e){i.uniform1iv(this.addr,e)}function fw(i,e){i.uniform2iv(this.addr,e)}function pw(i,e){i.uniform3iv(this.addr,e)}function mw(i,e){i.uniform4iv(this.addr,e)}function gw(i,e){i.uniform1uiv(this.addr,e)}function _w(i,e){i.uniform2uiv(this.addr,e)}function xw(i,e){i.uniform3uiv(this.addr,e)}function yw(i,e){i.uniform4uiv(this.addr,e)}function vw(i,e,t){let n=this.cache,s=e.length,r=Mh(t,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Sh(T0):o=w0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function bw(i,e,t){let n=this.cache,s=e.length,r=Mh(t,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||C0,r[o])}function Mw(i,e,t){let n=this.cache,s=e.length,r=Mh(t,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Sh(A0):o=R0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Sw(i,e,t){let n=this.cache,s=e.length,r=Mh(t,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||E0,r[o])}function ww(i){switch(i){case 5126:return rw;case 35664:return ow;case 35665:return aw;case 35666:return lw;case 35674:return cw;case 35675:return hw;case 35676:return uw;case 5124:case 35670:return dw;case 35667:case 35671:return fw;case 35668:case 35672:return pw;case 35669:case 35673:return mw;case 5125:return gw;case 36294:return _w;case 36295:return xw;case 36296:return yw;case 35678:case 36198:case 36298:case 36306:case 35682:return vw;case 35679:case 36299:case 36307:return bw;case 35680:case 36300:case 36308:case 36293:return Mw;case 36289:case 36303:case 36311:case 36292:return Sw}}var Yd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=sw(t.type)}},$d=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=ww(t.type)}},Zd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Xd=/(\w+)(\])?(\[|\.)?/g;function l0(i,e){i.seq.push(e),i.map[e.id]=e}function Tw(i,e,t){let n=i.name,s=n.length;for(Xd.lastIndex=0;;){let r=Xd.exec(n),o=Xd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){l0(t,c===void 0?new Yd(a,i,e):new $d(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Zd(a),l0(t,u)),t=u}}}var Io=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Tw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function c0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Aw=37297,Ew=0;function Cw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var h0=new at;function Rw(i){At._getMatrix(h0,At.workingColorSpace,i);let e=`mat3( ${h0.elements.map(t=>t.toFixed(4))} )`;switch(At.getTransfer(i)){case ca:return[e,"LinearTransferOETF"];case Ut:return[e,"sRGBTransferOETF"];default:return rt("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function u0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Cw(i.getShaderSource(e),a)}else return r}function Pw(i,e){let t=Rw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Iw={[_d]:"Linear",[xd]:"Reinhard",[yd]:"Cineon",[vd]:"ACESFilmic",[Md]:"AgX",[Sd]:"Neutral",[bd]:"Custom"};function Lw(i,e){let t=Iw[e];return t===void 0?(rt("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var vh=new F;function Dw(){At.getLuminanceCoefficients(vh);let i=vh.x.toFixed(4),e=vh.y.toFixed(4),t=vh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Nw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ba).join(`
`)}function Uw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Ow(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ba(i){return i!==""}function d0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function f0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Fw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Jd(i){return i.replace(Fw,Bw)}function Bw(i,e){let t=xt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Jd(t)}var kw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function p0(i){return i.replace(kw,zw)}function zw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function m0(i){let e=`precision ${i.precision} float;
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
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Gw={[Ra]:"SHADOWMAP_TYPE_PCF",[Eo]:"SHADOWMAP_TYPE_VSM"};function Hw(i){return Gw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Vw={[Ro]:"ENVMAP_MODE_REFRACTION"};function Ww(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Vw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Xw={[Pc]:"ENVMAP_BLENDING_MULTIPLY",[Dg]:"ENVMAP_BLENDING_MIX",[Ng]:"ENVMAP_BLENDING_ADD"};function qw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Xw[i.combine]||"ENVMAP_BLENDING_NONE"}function Yw(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Hw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Ww(t),u=qw(t),d=Nw(t),f=Uw(r),g=s.createProgram(),M,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ba).join(`
`),M.length>0&&(M+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ba).join(`
`),m.length>0&&(m+=`
`)):(M=[m0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ba).join(`
`),m=[m0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==es?"#define TONE_MAPPING":"",t.toneMapping!==es?xt.tonemapping_pars_fragment:"",t.toneMapping!==es?Lw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",xt.colorspace_pars_fragment,Pw("linearToOutputTexel",t.outputColorSpace),Dw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ba).join(`
`)),o=Jd(o),o=d0(o,t),o=f0(o,t),a=Jd(a),a=d0(a,t),a=f0(a,t),o=p0(o),a=p0(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,M=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,m=["#define varying in",t.glslVersion===Od?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Od?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let b=p+M+o,C=p+m+a,v=c0(s,s.VERTEX_SHADER,b),R=c0(s,s.FRAGMENT_SHADER,C);s.attachShader(g,v),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(N){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(v)||"",W=s.getShaderInfoLog(R)||"",L=D.trim(),H=k.trim(),q=W.trim(),V=!0,ce=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,v,R);else{let Y=u0(s,v,"vertex"),j=u0(s,R,"fragment");ht("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+L+`
`+Y+`
`+j)}else L!==""?rt("WebGLProgram: Program Info Log:",L):(H===""||q==="")&&(ce=!1);ce&&(N.diagnostics={runnable:V,programLog:L,vertexShader:{log:H,prefix:M},fragmentShader:{log:q,prefix:m}})}s.deleteShader(v),s.deleteShader(R),_=new Io(s,g),T=Ow(s,g)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,Aw)),B},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Ew++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=R,this}var $w=0,Kd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new jd(e),t.set(e,n)),n}},jd=class{constructor(e){this.id=$w++,this.code=e,this.usedTimes=0}};function Zw(i){return i===Zs||i===Ua||i===Oa}function Jw(i,e,t,n,s,r){let o=new _o,a=new Kd,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,T,B,N,D,k){let W=N.fog,L=D.geometry,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?N.environment:null,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=e.get(_.envMap||H,q),ce=d[_.type],Y=n.precision;_.precision!==null&&(Y=n.getMaxPrecision(_.precision),Y!==_.precision&&rt("WebGLProgram.getParameters:",_.precision,"not supported, using",Y,"instead."));let j=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ie=j!==void 0?j.length:0,pe=0;L.morphAttributes.position!==void 0&&(pe=1),L.morphAttributes.normal!==void 0&&(pe=2),L.morphAttributes.color!==void 0&&(pe=3);let he,ee,ge,Me;if(ce){let Ce=ns[ce];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=_.vertexShader,ee=_.fragmentShader;let Ce=a.getVertexShaderStage(_),lt=a.getFragmentShaderStage(_);a.update(_,Ce,lt),ge=Ce.id,Me=lt.id}let Le=i.getRenderTarget(),Ee=i.state.buffers.depth.getReversed(),je=D.isInstancedMesh===!0,ut=D.isBatchedMesh===!0,Je=!!_.map,ft=!!_.matcap,pt=!!V,ot=pt&&V.isPMREMTexture===!0,Ot=!!_.aoMap,Dt=!!_.lightMap,qt=!!_.bumpMap&&_.wireframe===!1,K=!!_.normalMap,de=!!_.displacementMap,xe=!!_.emissiveMap,Se=!!_.metalnessMap,_e=!!_.roughnessMap,$e=_.anisotropy>0,P=_.clearcoat>0,ue=_.diffuseRoughness>0,ze=_.dispersion>0,Ue=_.retroreflectivity>0,ye=_.iridescence>0,qe=_.sheen>0,Te=_.transmission>0,Ge=$e&&!!_.anisotropyMap,A=P&&!!_.clearcoatMap,y=P&&!!_.clearcoatNormalMap,z=P&&!!_.clearcoatRoughnessMap,se=ue&&!!_.diffuseRoughnessMap,Q=ye&&!!_.iridescenceMap,me=ye&&!!_.iridescenceThicknessMap,ve=qe&&!!_.sheenColorMap,te=qe&&!!_.sheenRoughnessMap,re=!!_.specularMap,be=!!_.specularColorMap,O=!!_.specularIntensityMap,ae=Te&&!!_.transmissionMap,oe=Te&&!!_.thicknessMap,Pe=!!_.gradientMap,Ae=!!_.alphaMap,Re=_.alphaTest>0,Qe=!!_.alphaHash,st=!!_.extensions,le=es;_.toneMapped&&(Le===null||Le.isXRRenderTarget===!0)&&(le=i.toneMapping);let Fe=ot?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,tt={shaderID:ce,shaderType:_.type,shaderName:_.name,vertexShader:he,fragmentShader:ee,defines:_.defines,customVertexShaderID:ge,customFragmentShaderID:Me,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Y,batching:ut,batchingColor:ut&&D._colorsTexture!==null,instancing:je,instancingColor:je&&D.instanceColor!==null,instancingMorph:je&&D.morphTexture!==null,outputColorSpace:Le===null?i.outputColorSpace:Le.isXRRenderTarget===!0?Le.texture.colorSpace:At.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Je,matcap:ft,envMap:pt,envMapMode:pt&&V.mapping,envMapPMREM:ot,envMapMaxLod:ot?Fe.length-1:null,envMapSize:ot?Fe[0].width:null,aoMap:Ot,lightMap:Dt,bumpMap:qt,normalMap:K,displacementMap:de,emissiveMap:xe,normalMapObjectSpace:K&&_.normalMapType===Fg,normalMapTangentSpace:K&&_.normalMapType===gh,packedNormalMap:K&&_.normalMapType===gh&&Zw(_.normalMap.format),metalnessMap:Se,roughnessMap:_e,anisotropy:$e,anisotropyMap:Ge,clearcoat:P,clearcoatMap:A,clearcoatNormalMap:y,clearcoatRoughnessMap:z,diffuseRoughness:ue,diffuseRoughnessMap:se,dispersion:ze,retroreflection:Ue,iridescence:ye,iridescenceMap:Q,iridescenceThicknessMap:me,sheen:qe,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:re,specularColorMap:be,specularIntensityMap:O,transmission:Te,transmissionMap:ae,thicknessMap:oe,gradientMap:Pe,opaque:_.transparent===!1&&_.blending===Co&&_.alphaToCoverage===!1,alphaMap:Ae,alphaTest:Re,alphaHash:Qe,combine:_.combine,mapUv:Je&&f(_.map.channel),aoMapUv:Ot&&f(_.aoMap.channel),lightMapUv:Dt&&f(_.lightMap.channel),bumpMapUv:qt&&f(_.bumpMap.channel),normalMapUv:K&&f(_.normalMap.channel),displacementMapUv:de&&f(_.displacementMap.channel),emissiveMapUv:xe&&f(_.emissiveMap.channel),metalnessMapUv:Se&&f(_.metalnessMap.channel),roughnessMapUv:_e&&f(_.roughnessMap.channel),anisotropyMapUv:Ge&&f(_.anisotropyMap.channel),clearcoatMapUv:A&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:se&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:me&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(_.sheenRoughnessMap.channel),specularMapUv:re&&f(_.specularMap.channel),specularColorMapUv:be&&f(_.specularColorMap.channel),specularIntensityMapUv:O&&f(_.specularIntensityMap.channel),transmissionMapUv:ae&&f(_.transmissionMap.channel),thicknessMapUv:oe&&f(_.thicknessMap.channel),alphaMapUv:Ae&&f(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(K||$e),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Je||Ae),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&K===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Ee,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:pe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&B.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:Je&&_.map.isVideoTexture===!0&&At.getTransfer(_.map.colorSpace)===Ut,decodeVideoTextureEmissive:xe&&_.emissiveMap.isVideoTexture===!0&&At.getTransfer(_.emissiveMap.colorSpace)===Ut,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Zn,flipSided:_.side===$n,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:st&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(st&&_.extensions.multiDraw===!0||ut)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function M(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let B in _.defines)T.push(B),T.push(_.defines[B]);return _.isRawShaderMaterial===!1&&(m(T,_),p(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function m(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function p(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function b(_){let T=d[_.type],B;if(T){let N=ns[T];B=Jg.clone(N.uniforms)}else B=_.uniforms;return B}function C(_,T){let B=h.get(T);return B!==void 0?++B.usedTimes:(B=new Yw(i,T,_,s),c.push(B),h.set(T,B)),B}function v(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:b,acquireProgram:C,releaseProgram:v,releaseShaderCache:R,programs:c,dispose:E}}function Kw(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function jw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function g0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function _0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,M,m,p){let b=i[e];return b===void 0?(b={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:M,renderOrder:d.renderOrder,z:m,group:p},i[e]=b):(b.id=d.id,b.object=d,b.geometry=f,b.material=g,b.materialVariant=o(d),b.groupOrder=M,b.renderOrder=d.renderOrder,b.z=m,b.group=p),e++,b}function l(d,f,g,M,m,p,b){b.reversedDepth===!0&&(m=-m);let C=a(d,f,g,M,m,p);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(d,f,g,M,m,p){let b=a(d,f,g,M,m,p);g.transmission>0?n.unshift(b):g.transparent===!0?s.unshift(b):t.unshift(b)}function h(d,f){t.length>1&&t.sort(d||jw),n.length>1&&n.sort(f||g0),s.length>1&&s.sort(f||g0)}function u(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Qw(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new _0,i.set(n,[o])):s>=r.length?(o=new _0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function eT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new F,color:new nt};break;case"SpotLight":t={position:new F,direction:new F,color:new nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new F,color:new nt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new F,skyColor:new nt,groundColor:new nt};break;case"RectAreaLight":t={color:new nt,position:new F,halfWidth:new F,halfHeight:new F};break}return i[e.id]=t,t}}}function tT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var nT=0;function iT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function sT(i){let e=new eT,t=tT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new F);let s=new F,r=new gt,o=new gt;function a(c){let h=0,u=0,d=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let f=0,g=0,M=0,m=0,p=0,b=0,C=0,v=0,R=0,E=0,_=0,T=0,B=0,N=0;c.sort(iT);for(let k=0,W=c.length;k<W;k++){let L=c[k],H=L.color,q=L.intensity,V=L.distance,ce=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Zs?ce=L.shadow.map.texture:ce=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=H.r*q,u+=H.g*q,d+=H.b*q;else if(L.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(L.sh.coefficients[Y],q);N++}else if(L.isSunLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=ce;let pe=j.getViewportCount();for(let he=0;he<pe;he++)n.sunShadowMatrix[M+he]=j.getMatrix(he),n.sunShadowCascade[M+he]=j._cascadeData[he];M+=pe,g++}n.sun[f]=Y,f++}else if(L.isDirectionalLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,n.directionalShadow[m]=ie,n.directionalShadowMap[m]=ce,n.directionalShadowMatrix[m]=L.shadow.matrix,R++}n.directional[m]=Y,m++}else if(L.isSpotLight){let Y=e.get(L);Y.position.setFromMatrixPosition(L.matrixWorld),Y.color.copy(H).multiplyScalar(q),Y.distance=V,Y.coneCos=Math.cos(L.angle),Y.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),Y.decay=L.decay,n.spot[b]=Y;let j=L.shadow;if(L.map&&(n.spotLightMap[T]=L.map,T++,j.updateMatrices(L),L.castShadow&&B++),n.spotLightMatrix[b]=j.matrix,L.castShadow){let ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,n.spotShadow[b]=ie,n.spotShadowMap[b]=ce,_++}b++}else if(L.isRectAreaLight){let Y=e.get(L);Y.color.copy(H).multiplyScalar(q),Y.halfWidth.set(L.width*.5,0,0),Y.halfHeight.set(0,L.height*.5,0),n.rectArea[C]=Y,C++}else if(L.isPointLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),Y.distance=L.distance,Y.decay=L.decay,L.castShadow){let j=L.shadow,ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,n.pointShadow[p]=ie,n.pointShadowMap[p]=ce,n.pointShadowMatrix[p]=L.shadow.matrix,E++}n.point[p]=Y,p++}else if(L.isHemisphereLight){let Y=e.get(L);Y.skyColor.copy(L.color).multiplyScalar(q),Y.groundColor.copy(L.groundColor).multiplyScalar(q),n.hemi[v]=Y,v++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ke.LTC_FLOAT_1,n.rectAreaLTC2=ke.LTC_FLOAT_2):(n.rectAreaLTC1=ke.LTC_HALF_1,n.rectAreaLTC2=ke.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==p||D.spotLength!==b||D.rectAreaLength!==C||D.hemiLength!==v||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==E||D.numSpotShadows!==_||D.numSpotMaps!==T||D.numLightProbes!==N)&&(n.sun.length=f,n.directional.length=m,n.spot.length=b,n.rectArea.length=C,n.point.length=p,n.hemi.length=v,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=M,n.sunShadowCascade.length=M,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-B,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=B,n.numLightProbes=N,D.sunLength=f,D.directionalLength=m,D.pointLength=p,D.spotLength=b,D.rectAreaLength=C,D.hemiLength=v,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=E,D.numSpotShadows=_,D.numSpotMaps=T,D.numLightProbes=N,n.version=nT++)}function l(c,h){let u=0,d=0,f=0,g=0,M=0,m=0,p=h.matrixWorldInverse;for(let b=0,C=c.length;b<C;b++){let v=c[b];if(v.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(v.matrixWorld),R.direction.transformDirection(p),u++}else if(v.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),d++}else if(v.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(v.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),g++}else if(v.isRectAreaLight){let R=n.rectArea[M];R.position.setFromMatrixPosition(v.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(v.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(v.width*.5,0,0),R.halfHeight.set(0,v.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),M++}else if(v.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(v.matrixWorld),R.position.applyMatrix4(p),f++}else if(v.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(v.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function x0(i){let e=new sT(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function rT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new x0(i),e.set(s,[a])):r>=o.length?(a=new x0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var oT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,aT=`uniform sampler2D shadow_pass;
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
}`,lT=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],cT=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],y0=new gt,Fa=new F,qd=new F;function hT(i,e,t){let n=new ji,s=new Xe,r=new Xe,o=new Rt,a=new gc,l=new _c,c={},h=t.maxTextureSize,u={[$s]:$n,[$n]:$s,[Zn]:Zn},d=new Qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xe},radius:{value:4}},vertexShader:oT,fragmentShader:aT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new en;g.setAttribute("position",new Cn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new tn(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ra;let p=this.type;this.render=function(E,_,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===pg&&(rt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ra);let B=i.getRenderTarget(),N=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),k=i.state;k.setBlending(gr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let W=p!==this.type;W&&_.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(H=>H.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,H=E.length;L<H;L++){let q=E[L],V=q.shadow;if(V===void 0){rt("WebGLShadowMap:",q,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ce=V.getFrameExtents();s.multiply(ce),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,V.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=Y,V.map===null||W===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Eo){if(q.isPointLight){rt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new ci(s.x,s.y,{format:Zs,type:Bi,minFilter:qn,magFilter:qn,generateMipmaps:!1}),V.map.texture.name=q.name+".shadowMap",V.map.depthTexture=new vs(s.x,s.y,Fi),V.map.depthTexture.name=q.name+".shadowMapDepth",V.map.depthTexture.format=_s,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Rn,V.map.depthTexture.magFilter=Rn}else q.isPointLight?(V.map=new ka(s.x),V.map.depthTexture=new xa(s.x,Oi)):(V.map=new ci(s.x,s.y),V.map.depthTexture=new vs(s.x,s.y,Oi)),V.map.depthTexture.name=q.name+".shadowMap",V.map.depthTexture.format=_s,this.type===Ra?(V.map.depthTexture.compareFunction=Y?Dd:Ld,V.map.depthTexture.minFilter=qn,V.map.depthTexture.magFilter=qn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Rn,V.map.depthTexture.magFilter=Rn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();q.isPointLight!==!0&&V.updateMatrices(q,T);let ie=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:T.layers;for(let pe=0;pe<j;pe++){let he=V.getCamera(pe);if(q.isPointLight){let ee=V.camera,ge=V.matrix,Me=q.distance||ee.far;Me!==ee.far&&(ee.far=Me,ee.updateProjectionMatrix()),Fa.setFromMatrixPosition(q.matrixWorld),ee.position.copy(Fa),qd.copy(ee.position),qd.add(lT[pe]),ee.up.copy(cT[pe]),ee.lookAt(qd),ee.updateMatrixWorld(),ge.makeTranslation(-Fa.x,-Fa.y,-Fa.z),y0.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(y0,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,pe),i.clear();else{pe===0&&(i.setRenderTarget(V.map),i.clear());let ee=V.getViewport(pe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),k.viewport(o)}n=V.getFrustum(pe),v(_,T,he,q,ie,this.type)}V.isPointLightShadow!==!0&&this.type===Eo&&b(V,T),V.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(B,N,D)};function b(E,_){let T=e.update(M);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new ci(s.x,s.y,{format:Zs,type:Bi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,T,d,M,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,T,f,M,null)}function C(E,_,T,B){let N=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)N=D;else if(N=T.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=N.uuid,W=_.uuid,L=c[k];L===void 0&&(L={},c[k]=L);let H=L[W];H===void 0&&(H=N.clone(),L[W]=H,_.addEventListener("dispose",R)),N=H}if(N.visible=_.visible,N.wireframe=_.wireframe,B===Eo?N.side=_.shadowSide!==null?_.shadowSide:_.side:N.side=_.shadowSide!==null?_.shadowSide:u[_.side],N.alphaMap=_.alphaMap,N.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,N.map=_.map,N.clipShadows=_.clipShadows,N.clippingPlanes=_.clippingPlanes,N.clipIntersection=_.clipIntersection,N.displacementMap=_.displacementMap,N.displacementScale=_.displacementScale,N.displacementBias=_.displacementBias,N.wireframeLinewidth=_.wireframeLinewidth,N.linewidth=_.linewidth,T.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let k=i.properties.get(N);k.light=T}return N}function v(E,_,T,B,N,D){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Eo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let L=e.update(E),H=E.material;if(Array.isArray(H)){let q=L.groups;for(let V=0,ce=q.length;V<ce;V++){let Y=q[V],j=H[Y.materialIndex];if(j&&j.visible){let ie=C(E,j,B,D);E.onBeforeShadow(i,E,_,T,L,ie,Y),i.renderBufferDirect(T,null,L,ie,E,Y),E.onAfterShadow(i,E,_,T,L,ie,Y)}}}else if(H.visible){let q=C(E,H,B,D);E.onBeforeShadow(i,E,_,T,L,q,null),i.renderBufferDirect(T,null,L,q,E,null),E.onAfterShadow(i,E,_,T,L,q,null)}}let W=E.children;for(let L=0,H=W.length;L<H;L++)v(W[L],_,T,B,N,D)}function R(E){E.target.removeEventListener("dispose",R);for(let T in c){let B=c[T],N=E.target.uuid;N in B&&(B[N].dispose(),delete B[N])}}}function uT(i,e){function t(){let O=!1,ae=new Rt,oe=null,Pe=new Rt(0,0,0,0);return{setMask:function(Ae){oe!==Ae&&!O&&(i.colorMask(Ae,Ae,Ae,Ae),oe=Ae)},setLocked:function(Ae){O=Ae},setClear:function(Ae,Re,Qe,st,le){le===!0&&(Ae*=st,Re*=st,Qe*=st),ae.set(Ae,Re,Qe,st),Pe.equals(ae)===!1&&(i.clearColor(Ae,Re,Qe,st),Pe.copy(ae))},reset:function(){O=!1,oe=null,Pe.set(-1,0,0,0)}}}function n(){let O=!1,ae=!1,oe=null,Pe=null,Ae=null;return{setReversed:function(Re){if(ae!==Re){let Qe=e.get("EXT_clip_control");Re?Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.ZERO_TO_ONE_EXT):Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.NEGATIVE_ONE_TO_ONE_EXT),ae=Re;let st=Ae;Ae=null,this.setClear(st)}},getReversed:function(){return ae},setTest:function(Re){Re?Ee(i.DEPTH_TEST):je(i.DEPTH_TEST)},setMask:function(Re){oe!==Re&&!O&&(i.depthMask(Re),oe=Re)},setFunc:function(Re){if(ae&&(Re=Yg[Re]),Pe!==Re){switch(Re){case jl:i.depthFunc(i.NEVER);break;case Ql:i.depthFunc(i.ALWAYS);break;case ec:i.depthFunc(i.LESS);break;case uo:i.depthFunc(i.LEQUAL);break;case tc:i.depthFunc(i.EQUAL);break;case nc:i.depthFunc(i.GEQUAL);break;case ic:i.depthFunc(i.GREATER);break;case sc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Pe=Re}},setLocked:function(Re){O=Re},setClear:function(Re){Ae!==Re&&(Ae=Re,ae&&(Re=1-Re),i.clearDepth(Re))},reset:function(){O=!1,oe=null,Pe=null,Ae=null,ae=!1}}}function s(){let O=!1,ae=null,oe=null,Pe=null,Ae=null,Re=null,Qe=null,st=null,le=null;return{setTest:function(Fe){O||(Fe?Ee(i.STENCIL_TEST):je(i.STENCIL_TEST))},setMask:function(Fe){ae!==Fe&&!O&&(i.stencilMask(Fe),ae=Fe)},setFunc:function(Fe,tt,Ce){(oe!==Fe||Pe!==tt||Ae!==Ce)&&(i.stencilFunc(Fe,tt,Ce),oe=Fe,Pe=tt,Ae=Ce)},setOp:function(Fe,tt,Ce){(Re!==Fe||Qe!==tt||st!==Ce)&&(i.stencilOp(Fe,tt,Ce),Re=Fe,Qe=tt,st=Ce)},setLocked:function(Fe){O=Fe},setClear:function(Fe){le!==Fe&&(i.clearStencil(Fe),le=Fe)},reset:function(){O=!1,ae=null,oe=null,Pe=null,Ae=null,Re=null,Qe=null,st=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],M=null,m=!1,p=null,b=null,C=null,v=null,R=null,E=null,_=null,T=new nt(0,0,0),B=0,N=!1,D=null,k=null,W=null,L=null,H=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ce=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Y)[1]),V=ce>=1):Y.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),V=ce>=2);let j=null,ie={},pe=i.getParameter(i.SCISSOR_BOX),he=i.getParameter(i.VIEWPORT),ee=new Rt().fromArray(pe),ge=new Rt().fromArray(he);function Me(O,ae,oe,Pe){let Ae=new Uint8Array(4),Re=i.createTexture();i.bindTexture(O,Re),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qe=0;Qe<oe;Qe++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(ae,0,i.RGBA,1,1,Pe,0,i.RGBA,i.UNSIGNED_BYTE,Ae):i.texImage2D(ae+Qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ae);return Re}let Le={};Le[i.TEXTURE_2D]=Me(i.TEXTURE_2D,i.TEXTURE_2D,1),Le[i.TEXTURE_CUBE_MAP]=Me(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Le[i.TEXTURE_2D_ARRAY]=Me(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Le[i.TEXTURE_3D]=Me(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Ee(i.DEPTH_TEST),o.setFunc(uo),qt(!1),K(ud),Ee(i.CULL_FACE),Ot(gr);function Ee(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function je(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function ut(O,ae){return d[O]!==ae?(i.bindFramebuffer(O,ae),d[O]=ae,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=ae),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=ae),!0):!1}function Je(O,ae){let oe=g,Pe=!1;if(O){oe=f.get(ae),oe===void 0&&(oe=[],f.set(ae,oe));let Ae=O.textures;if(oe.length!==Ae.length||oe[0]!==i.COLOR_ATTACHMENT0){for(let Re=0,Qe=Ae.length;Re<Qe;Re++)oe[Re]=i.COLOR_ATTACHMENT0+Re;oe.length=Ae.length,Pe=!0}}else oe[0]!==i.BACK&&(oe[0]=i.BACK,Pe=!0);Pe&&i.drawBuffers(oe)}function ft(O){return M!==O?(i.useProgram(O),M=O,!0):!1}let pt={[_r]:i.FUNC_ADD,[gg]:i.FUNC_SUBTRACT,[_g]:i.FUNC_REVERSE_SUBTRACT};pt[xg]=i.MIN,pt[yg]=i.MAX;let ot={[vg]:i.ZERO,[bg]:i.ONE,[Mg]:i.SRC_COLOR,[md]:i.SRC_ALPHA,[Cg]:i.SRC_ALPHA_SATURATE,[Ag]:i.DST_COLOR,[wg]:i.DST_ALPHA,[Sg]:i.ONE_MINUS_SRC_COLOR,[gd]:i.ONE_MINUS_SRC_ALPHA,[Eg]:i.ONE_MINUS_DST_COLOR,[Tg]:i.ONE_MINUS_DST_ALPHA,[Rg]:i.CONSTANT_COLOR,[Pg]:i.ONE_MINUS_CONSTANT_COLOR,[Ig]:i.CONSTANT_ALPHA,[Lg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ot(O,ae,oe,Pe,Ae,Re,Qe,st,le,Fe){if(O===gr){m===!0&&(je(i.BLEND),m=!1);return}if(m===!1&&(Ee(i.BLEND),m=!0),O!==mg){if(O!==p||Fe!==N){if((b!==_r||R!==_r)&&(i.blendEquation(i.FUNC_ADD),b=_r,R=_r),Fe)switch(O){case Co:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case dd:i.blendFunc(i.ONE,i.ONE);break;case fd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case pd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ht("WebGLState: Invalid blending: ",O);break}else switch(O){case Co:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case dd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case fd:ht("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case pd:ht("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ht("WebGLState: Invalid blending: ",O);break}C=null,v=null,E=null,_=null,T.set(0,0,0),B=0,p=O,N=Fe}return}Ae=Ae||ae,Re=Re||oe,Qe=Qe||Pe,(ae!==b||Ae!==R)&&(i.blendEquationSeparate(pt[ae],pt[Ae]),b=ae,R=Ae),(oe!==C||Pe!==v||Re!==E||Qe!==_)&&(i.blendFuncSeparate(ot[oe],ot[Pe],ot[Re],ot[Qe]),C=oe,v=Pe,E=Re,_=Qe),(st.equals(T)===!1||le!==B)&&(i.blendColor(st.r,st.g,st.b,le),T.copy(st),B=le),p=O,N=!1}function Dt(O,ae){O.side===Zn?je(i.CULL_FACE):Ee(i.CULL_FACE);let oe=O.side===$n;ae&&(oe=!oe),qt(oe),O.blending===Co&&O.transparent===!1?Ot(gr):Ot(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Pe=O.stencilWrite;a.setTest(Pe),Pe&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),xe(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?Ee(i.SAMPLE_ALPHA_TO_COVERAGE):je(i.SAMPLE_ALPHA_TO_COVERAGE)}function qt(O){D!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),D=O)}function K(O){O!==dg?(Ee(i.CULL_FACE),O!==k&&(O===ud?i.cullFace(i.BACK):O===fg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):je(i.CULL_FACE),k=O}function de(O){O!==W&&(V&&i.lineWidth(O),W=O)}function xe(O,ae,oe){O?(Ee(i.POLYGON_OFFSET_FILL),(L!==ae||H!==oe)&&(L=ae,H=oe,o.getReversed()&&(ae=-ae,oe=-oe),i.polygonOffset(ae,oe))):je(i.POLYGON_OFFSET_FILL)}function Se(O){O?Ee(i.SCISSOR_TEST):je(i.SCISSOR_TEST)}function _e(O){O===void 0&&(O=i.TEXTURE0+q-1),j!==O&&(i.activeTexture(O),j=O)}function $e(O,ae,oe){oe===void 0&&(j===null?oe=i.TEXTURE0+q-1:oe=j);let Pe=ie[oe];Pe===void 0&&(Pe={type:void 0,texture:void 0},ie[oe]=Pe),(Pe.type!==O||Pe.texture!==ae)&&(j!==oe&&(i.activeTexture(oe),j=oe),i.bindTexture(O,ae||Le[O]),Pe.type=O,Pe.texture=ae)}function P(){let O=ie[j];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function ue(){try{i.compressedTexImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function ze(){try{i.compressedTexImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function Ue(){try{i.texSubImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function ye(){try{i.texSubImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function qe(){try{i.compressedTexSubImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function Te(){try{i.compressedTexSubImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function Ge(){try{i.texStorage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function A(){try{i.texStorage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function y(){try{i.texImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function z(){try{i.texImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function se(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function Q(O,ae){u[O]!==ae&&(i.pixelStorei(O,ae),u[O]=ae)}function me(O){ee.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ve(O){ge.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),ge.copy(O))}function te(O,ae){let oe=c.get(ae);oe===void 0&&(oe=new WeakMap,c.set(ae,oe));let Pe=oe.get(O);Pe===void 0&&(Pe=i.getUniformBlockIndex(ae,O.name),i.uniformBlockBinding(ae,Pe,Pe),oe.set(O,Pe))}function re(O,ae,oe){let Ae=c.get(ae).get(O);l[Ae]!==oe&&(i.bindBufferBase(i.UNIFORM_BUFFER,Ae,oe),l[Ae]=oe)}function be(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,ie={},d={},l={},f=new WeakMap,g=[],M=null,m=!1,p=null,b=null,C=null,v=null,R=null,E=null,_=null,T=new nt(0,0,0),B=0,N=!1,D=null,k=null,W=null,L=null,H=null,ee.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Ee,disable:je,bindFramebuffer:ut,drawBuffers:Je,useProgram:ft,setBlending:Ot,setMaterial:Dt,setFlipSided:qt,setCullFace:K,setLineWidth:de,setPolygonOffset:xe,setScissorTest:Se,activeTexture:_e,bindTexture:$e,unbindTexture:P,compressedTexImage2D:ue,compressedTexImage3D:ze,texImage2D:y,texImage3D:z,pixelStorei:Q,getParameter:se,updateUBOMapping:te,uniformBlockBinding:re,texStorage2D:Ge,texStorage3D:A,texSubImage2D:Ue,texSubImage3D:ye,compressedTexSubImage2D:qe,compressedTexSubImage3D:Te,scissor:me,viewport:ve,reset:be}}function dT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xe,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,M=new FinalizationRegistry(A=>g.delete(A)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(A,y){return m?new OffscreenCanvas(A,y):ha("canvas")}function b(A,y,z){let se=1,Q=Ge(A);if((Q.width>z||Q.height>z)&&(se=z/Math.max(Q.width,Q.height)),se<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let me=Math.floor(se*Q.width),ve=Math.floor(se*Q.height);d===void 0&&(d=p(me,ve));let te=y?p(me,ve):d;return te.width=me,te.height=ve,te.getContext("2d").drawImage(A,0,0,me,ve),rt("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+me+"x"+ve+")."),te}else return"data"in A&&rt("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),A;return A}function C(A){return A.generateMipmaps}function v(A){i.generateMipmap(A)}function R(A){return A.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?i.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(A,y,z,se,Q,me=!1){if(A!==null){if(i[A]!==void 0)return i[A];rt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let ve;se&&(ve=e.get("EXT_texture_norm16"),ve||rt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=y;if(y===i.RED&&(z===i.FLOAT&&(te=i.R32F),z===i.HALF_FLOAT&&(te=i.R16F),z===i.UNSIGNED_BYTE&&(te=i.R8),z===i.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),z===i.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),y===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(te=i.R8UI),z===i.UNSIGNED_SHORT&&(te=i.R16UI),z===i.UNSIGNED_INT&&(te=i.R32UI),z===i.BYTE&&(te=i.R8I),z===i.SHORT&&(te=i.R16I),z===i.INT&&(te=i.R32I)),y===i.RG&&(z===i.FLOAT&&(te=i.RG32F),z===i.HALF_FLOAT&&(te=i.RG16F),z===i.UNSIGNED_BYTE&&(te=i.RG8),z===i.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),z===i.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),y===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(te=i.RG8UI),z===i.UNSIGNED_SHORT&&(te=i.RG16UI),z===i.UNSIGNED_INT&&(te=i.RG32UI),z===i.BYTE&&(te=i.RG8I),z===i.SHORT&&(te=i.RG16I),z===i.INT&&(te=i.RG32I)),y===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(te=i.RGB8UI),z===i.UNSIGNED_SHORT&&(te=i.RGB16UI),z===i.UNSIGNED_INT&&(te=i.RGB32UI),z===i.BYTE&&(te=i.RGB8I),z===i.SHORT&&(te=i.RGB16I),z===i.INT&&(te=i.RGB32I)),y===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),z===i.UNSIGNED_INT&&(te=i.RGBA32UI),z===i.BYTE&&(te=i.RGBA8I),z===i.SHORT&&(te=i.RGBA16I),z===i.INT&&(te=i.RGBA32I)),y===i.RGB&&(z===i.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),z===i.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),z===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),z===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),y===i.RGBA){let re=me?ca:At.getTransfer(Q);z===i.FLOAT&&(te=i.RGBA32F),z===i.HALF_FLOAT&&(te=i.RGBA16F),z===i.UNSIGNED_BYTE&&(te=re===Ut?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),z===i.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),z===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(A,y){let z;return A?y===null||y===Oi||y===yr?z=i.DEPTH24_STENCIL8:y===Fi?z=i.DEPTH32F_STENCIL8:y===Po&&(z=i.DEPTH24_STENCIL8,rt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Oi||y===yr?z=i.DEPTH_COMPONENT24:y===Fi?z=i.DEPTH_COMPONENT32F:y===Po&&(z=i.DEPTH_COMPONENT16),z}function T(A,y){return C(A)===!0||A.isFramebufferTexture&&A.minFilter!==Rn&&A.minFilter!==qn?Math.log2(Math.max(y.width,y.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?y.mipmaps.length:1}function B(A){let y=new WeakRef(A);n.get(A).__ref=y,g.add(y),M.register(A,y,y)}function N(A){let y=n.get(A).__ref;y!==void 0&&(g.delete(y),M.unregister(y))}function D(A){W(A.target)}function k(A){L(A.target)}function W(A){A.removeEventListener("dispose",D),N(A),q(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function L(A){A.removeEventListener("dispose",k),N(A),ce(A)}function H(){for(let A of g){let y=A.deref();y!==void 0&&(y.isRenderTarget===!0?L(y):W(y))}g.clear(),u.clear()}function q(A){let y=n.get(A);if(y.__webglInit===void 0)return;let z=A.source,se=f.get(z);if(se){let Q=se[y.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&V(A),Object.keys(se).length===0&&f.delete(z)}n.remove(A)}function V(A){let y=n.get(A);i.deleteTexture(y.__webglTexture);let z=A.source,se=f.get(z);delete se[y.__cacheKey],o.memory.textures--}function ce(A){let y=n.get(A);y.__depthDisposeCallback&&y.__depthDisposeCallback();let z=A.depthTexture;if(z&&z.renderTarget===A&&W(z),A.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(y.__webglFramebuffer[Q]))for(let me=0;me<y.__webglFramebuffer[Q].length;me++)i.deleteFramebuffer(y.__webglFramebuffer[Q][me]);else i.deleteFramebuffer(y.__webglFramebuffer[Q]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[Q])}else{if(Array.isArray(y.__webglFramebuffer))for(let Q=0;Q<y.__webglFramebuffer.length;Q++)i.deleteFramebuffer(y.__webglFramebuffer[Q]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Q=0;Q<y.__webglColorRenderbuffer.length;Q++)y.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[Q]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let se=A.textures;for(let Q=0,me=se.length;Q<me;Q++){let ve=n.get(se[Q]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(se[Q])}n.remove(A)}let Y=0;function j(){Y=0}function ie(){return Y}function pe(A){Y=A}function he(){let A=Y;return A>=s.maxTextures&&rt("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,A}function ee(A){let y=[];return y.push(A.wrapS),y.push(A.wrapT),y.push(A.wrapR||0),y.push(A.magFilter),y.push(A.minFilter),y.push(A.anisotropy),y.push(A.internalFormat),y.push(A.format),y.push(A.type),y.push(A.generateMipmaps),y.push(A.mipmapsAutoUpdate),y.push(A.premultiplyAlpha),y.push(A.flipY),y.push(A.unpackAlignment),y.push(A.colorSpace),y.join()}function ge(A,y){let z=n.get(A);if(A.isVideoTexture&&qe(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&z.__version!==A.version){let se=A.image;if(se===null)rt("WebGLRenderer: Texture marked for update but no image data found.");else if(se.complete===!1)rt("WebGLRenderer: Texture marked for update but image is incomplete");else{Dt(z,A,y);return}}else A.isExternalTexture&&(z.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+y)}function Me(A,y){let z=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&z.__version!==A.version){Dt(z,A,y);return}else A.isExternalTexture&&(z.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+y)}function Le(A,y){let z=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&z.__version!==A.version){Dt(z,A,y);return}t.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+y)}function Ee(A,y){let z=n.get(A);if(A.version>0&&z.__version!==A.version){qt(z,A,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+y)}let je={[rc]:i.REPEAT,[Ji]:i.CLAMP_TO_EDGE,[oc]:i.MIRRORED_REPEAT},ut={[Rn]:i.NEAREST,[Ug]:i.NEAREST_MIPMAP_NEAREST,[Pa]:i.NEAREST_MIPMAP_LINEAR,[qn]:i.LINEAR,[Dc]:i.LINEAR_MIPMAP_NEAREST,[bs]:i.LINEAR_MIPMAP_LINEAR},Je={[kg]:i.NEVER,[Nd]:i.ALWAYS,[zg]:i.LESS,[Ld]:i.LEQUAL,[Gg]:i.EQUAL,[Dd]:i.GEQUAL,[Hg]:i.GREATER,[Vg]:i.NOTEQUAL};function ft(A,y){if(y.type===Fi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===qn||y.magFilter===Dc||y.magFilter===Pa||y.magFilter===bs||y.minFilter===qn||y.minFilter===Dc||y.minFilter===Pa||y.minFilter===bs)&&rt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(A,i.TEXTURE_WRAP_S,je[y.wrapS]),i.texParameteri(A,i.TEXTURE_WRAP_T,je[y.wrapT]),(A===i.TEXTURE_3D||A===i.TEXTURE_2D_ARRAY)&&i.texParameteri(A,i.TEXTURE_WRAP_R,je[y.wrapR]),i.texParameteri(A,i.TEXTURE_MAG_FILTER,ut[y.magFilter]),i.texParameteri(A,i.TEXTURE_MIN_FILTER,ut[y.minFilter]),y.compareFunction&&(i.texParameteri(A,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(A,i.TEXTURE_COMPARE_FUNC,Je[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Rn||y.minFilter!==Pa&&y.minFilter!==bs||y.type===Fi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(A,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function pt(A,y){let z=!1;A.__webglInit===void 0&&(A.__webglInit=!0,y.addEventListener("dispose",D),B(y));let se=y.source,Q=f.get(se);Q===void 0&&(Q={},f.set(se,Q));let me=ee(y);if(me!==A.__cacheKey){Q[me]===void 0&&(Q[me]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),Q[me].usedTimes++;let ve=Q[A.__cacheKey];ve!==void 0&&(Q[A.__cacheKey].usedTimes--,ve.usedTimes===0&&V(y)),A.__cacheKey=me,A.__webglTexture=Q[me].texture}return z}function ot(A,y,z){return Math.floor(Math.floor(A/z)/y)}function Ot(A,y,z,se){let me=A.updateRanges;if(me.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,z,se,y.data);else{me.sort((O,ae)=>O.start-ae.start);let ve=0;for(let O=1;O<me.length;O++){let ae=me[ve],oe=me[O],Pe=ae.start+ae.count,Ae=ot(oe.start,y.width,4),Re=ot(ae.start,y.width,4);oe.start<=Pe+1&&Ae===Re&&ot(oe.start+oe.count-1,y.width,4)===Ae?ae.count=Math.max(ae.count,oe.start+oe.count-ae.start):(++ve,me[ve]=oe)}me.length=ve+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),be=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let O=0,ae=me.length;O<ae;O++){let oe=me[O],Pe=Math.floor(oe.start/4),Ae=Math.ceil(oe.count/4),Re=Pe%y.width,Qe=Math.floor(Pe/y.width),st=Ae,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Re),t.pixelStorei(i.UNPACK_SKIP_ROWS,Qe),t.texSubImage2D(i.TEXTURE_2D,0,Re,Qe,st,le,z,se,y.data)}A.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,be)}}function Dt(A,y,z){let se=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(se=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(se=i.TEXTURE_3D);let Q=pt(A,y),me=y.source;t.bindTexture(se,A.__webglTexture,i.TEXTURE0+z);let ve=n.get(me);if(me.version!==ve.__version||Q===!0){if(t.activeTexture(i.TEXTURE0+z),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let le=At.getPrimaries(At.workingColorSpace),Fe=y.colorSpace===Ss?null:At.getPrimaries(y.colorSpace),tt=y.colorSpace===Ss||le===Fe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment);let re=b(y.image,!1,s.maxTextureSize);re=Te(y,re);let be=r.convert(y.format,y.colorSpace),O=r.convert(y.type),ae=E(y.internalFormat,be,O,y.normalized,y.colorSpace,y.isVideoTexture);ft(se,y);let oe,Pe=y.mipmaps,Ae=y.isVideoTexture!==!0,Re=ve.__version===void 0||Q===!0,Qe=me.dataReady,st=T(y,re);if(y.isDepthTexture)ae=_(y.format===Ms,y.type),Re&&(Ae?t.texStorage2D(i.TEXTURE_2D,1,ae,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,ae,re.width,re.height,0,be,O,null));else if(y.isDataTexture)if(Pe.length>0){Ae&&Re&&t.texStorage2D(i.TEXTURE_2D,st,ae,Pe[0].width,Pe[0].height);for(let le=0,Fe=Pe.length;le<Fe;le++)oe=Pe[le],Ae?Qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,oe.width,oe.height,be,O,oe.data):t.texImage2D(i.TEXTURE_2D,le,ae,oe.width,oe.height,0,be,O,oe.data);y.generateMipmaps=!1}else Ae?(Re&&t.texStorage2D(i.TEXTURE_2D,st,ae,re.width,re.height),Qe&&Ot(y,re,be,O)):t.texImage2D(i.TEXTURE_2D,0,ae,re.width,re.height,0,be,O,re.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){Ae&&Re&&t.texStorage3D(i.TEXTURE_2D_ARRAY,st,ae,Pe[0].width,Pe[0].height,re.depth);for(let le=0,Fe=Pe.length;le<Fe;le++)if(oe=Pe[le],y.format!==ki)if(be!==null)if(Ae){if(Qe)if(y.layerUpdates.size>0){let tt=Wd(oe.width,oe.height,y.format,y.type);for(let Ce of y.layerUpdates){let lt=oe.data.subarray(Ce*tt/oe.data.BYTES_PER_ELEMENT,(Ce+1)*tt/oe.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Ce,oe.width,oe.height,1,be,lt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,oe.width,oe.height,re.depth,be,oe.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,ae,oe.width,oe.height,re.depth,0,oe.data,0,0);else rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ae?Qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,oe.width,oe.height,re.depth,be,O,oe.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,ae,oe.width,oe.height,re.depth,0,be,O,oe.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{Ae&&Re&&t.texStorage2D(i.TEXTURE_2D,st,ae,Pe[0].width,Pe[0].height);for(let le=0,Fe=Pe.length;le<Fe;le++)oe=Pe[le],y.format!==ki?be!==null?Ae?Qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,oe.width,oe.height,be,oe.data):t.compressedTexImage2D(i.TEXTURE_2D,le,ae,oe.width,oe.height,0,oe.data):rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ae?Qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,oe.width,oe.height,be,O,oe.data):t.texImage2D(i.TEXTURE_2D,le,ae,oe.width,oe.height,0,be,O,oe.data)}else if(y.isDataArrayTexture)if(Ae){if(Re&&t.texStorage3D(i.TEXTURE_2D_ARRAY,st,ae,re.width,re.height,re.depth),Qe)if(y.layerUpdates.size>0){let le=Wd(re.width,re.height,y.format,y.type);for(let Fe of y.layerUpdates){let tt=re.data.subarray(Fe*le/re.data.BYTES_PER_ELEMENT,(Fe+1)*le/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Fe,re.width,re.height,1,be,O,tt)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,be,O,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ae,re.width,re.height,re.depth,0,be,O,re.data);else if(y.isData3DTexture)Ae?(Re&&t.texStorage3D(i.TEXTURE_3D,st,ae,re.width,re.height,re.depth),Qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,be,O,re.data)):t.texImage3D(i.TEXTURE_3D,0,ae,re.width,re.height,re.depth,0,be,O,re.data);else if(y.isFramebufferTexture){if(Re)if(Ae)t.texStorage2D(i.TEXTURE_2D,st,ae,re.width,re.height);else{let le=re.width,Fe=re.height;for(let tt=0;tt<st;tt++)t.texImage2D(i.TEXTURE_2D,tt,ae,le,Fe,0,be,O,null),le>>=1,Fe>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),re.parentNode!==le){le.appendChild(re),u.add(y),le.onpaint=Fe=>{let tt=Fe.changedElements;for(let Ce of u)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let tt=i.RGBA,Ce=i.RGBA,lt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Ce,lt,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Pe.length>0){if(Ae&&Re){let le=Ge(Pe[0]);t.texStorage2D(i.TEXTURE_2D,st,ae,le.width,le.height)}for(let le=0,Fe=Pe.length;le<Fe;le++)oe=Pe[le],Ae?Qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,be,O,oe):t.texImage2D(i.TEXTURE_2D,le,ae,be,O,oe);y.generateMipmaps=!1}else if(Ae){if(Re){let le=Ge(re);t.texStorage2D(i.TEXTURE_2D,st,ae,le.width,le.height)}Qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,be,O,re)}else t.texImage2D(i.TEXTURE_2D,0,ae,be,O,re);C(y)&&y.mipmapsAutoUpdate===!0&&v(se),ve.__version=me.version,y.onUpdate&&y.onUpdate(y)}A.__version=y.version}function qt(A,y,z){if(y.image.length!==6)return;let se=pt(A,y),Q=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,A.__webglTexture,i.TEXTURE0+z);let me=n.get(Q);if(Q.version!==me.__version||se===!0){t.activeTexture(i.TEXTURE0+z);let ve=At.getPrimaries(At.workingColorSpace),te=y.colorSpace===Ss?null:At.getPrimaries(y.colorSpace),re=y.colorSpace===Ss||ve===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let be=y.isCompressedTexture||y.image[0].isCompressedTexture,O=y.image[0]&&y.image[0].isDataTexture,ae=[];for(let Ce=0;Ce<6;Ce++)!be&&!O?ae[Ce]=b(y.image[Ce],!0,s.maxCubemapSize):ae[Ce]=O?y.image[Ce].image:y.image[Ce],ae[Ce]=Te(y,ae[Ce]);let oe=ae[0],Pe=r.convert(y.format,y.colorSpace),Ae=r.convert(y.type),Re=E(y.internalFormat,Pe,Ae,y.normalized,y.colorSpace),Qe=y.isVideoTexture!==!0,st=me.__version===void 0||se===!0,le=Q.dataReady,Fe=T(y,oe);ft(i.TEXTURE_CUBE_MAP,y);let tt;if(y.isDepthTexture){if(Re=_(y.format===Ms,y.type),st)if(Qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Re,oe.width,oe.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Re,oe.width,oe.height,0,Pe,Ae,null)}else if(be){Qe&&st&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Fe,Re,oe.width,oe.height);for(let Ce=0;Ce<6;Ce++){tt=ae[Ce].mipmaps;for(let lt=0;lt<tt.length;lt++){let Gt=tt[lt];y.format!==ki?Pe!==null?Qe?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Gt.width,Gt.height,Pe,Gt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Re,Gt.width,Gt.height,0,Gt.data):rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Gt.width,Gt.height,Pe,Ae,Gt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Re,Gt.width,Gt.height,0,Pe,Ae,Gt.data)}}}else{if(tt=y.mipmaps,Qe&&st){tt.length>0&&Fe++;let Ce=Ge(ae[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Fe,Re,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,ae[Ce].width,ae[Ce].height,Pe,Ae,ae[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Re,ae[Ce].width,ae[Ce].height,0,Pe,Ae,ae[Ce].data);for(let lt=0;lt<tt.length;lt++){let Ln=tt[lt].image[Ce].image;Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Ln.width,Ln.height,Pe,Ae,Ln.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Re,Ln.width,Ln.height,0,Pe,Ae,Ln.data)}}else{Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Pe,Ae,ae[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Re,Pe,Ae,ae[Ce]);for(let lt=0;lt<tt.length;lt++){let Gt=tt[lt];Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Pe,Ae,Gt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Re,Pe,Ae,Gt.image[Ce])}}}C(y)&&y.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),me.__version=Q.version,y.onUpdate&&y.onUpdate(y)}A.__version=y.version}function K(A,y,z,se,Q,me){let ve=r.convert(z.format,z.colorSpace),te=r.convert(z.type),re=E(z.internalFormat,ve,te,z.normalized,z.colorSpace),be=n.get(y),O=n.get(z);if(O.__renderTarget=y,!be.__hasExternalTextures){let ae=Math.max(1,y.width>>me),oe=Math.max(1,y.height>>me);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?t.texImage3D(Q,me,re,ae,oe,y.depth,0,ve,te,null):t.texImage2D(Q,me,re,ae,oe,0,ve,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,A),ye(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,se,Q,O.__webglTexture,0,Ue(y)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,se,Q,O.__webglTexture,me),t.bindFramebuffer(i.FRAMEBUFFER,null)}function de(A,y,z){if(i.bindRenderbuffer(i.RENDERBUFFER,A),y.depthBuffer){let se=y.depthTexture,Q=se&&se.isDepthTexture?se.type:null,me=_(y.stencilBuffer,Q),ve=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ye(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ue(y),me,y.width,y.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ue(y),me,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,me,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,A)}else{let se=y.textures;for(let Q=0;Q<se.length;Q++){let me=se[Q],ve=r.convert(me.format,me.colorSpace),te=r.convert(me.type),re=E(me.internalFormat,ve,te,me.normalized,me.colorSpace);ye(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ue(y),re,y.width,y.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ue(y),re,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,re,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(A,y,z){let se=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,A),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(y.depthTexture);Q.__renderTarget=y;let me=se?y.depthTexture.image[0]:y.depthTexture.image;(!Q.__webglTexture||me.width!==y.width||me.height!==y.height)&&(me.width=y.width,me.height=y.height,y.depthTexture.needsUpdate=!0),se?Ee(y.depthTexture,0):ge(y.depthTexture,0);let ve=Q.__webglTexture,te=Ue(y),re=se?i.TEXTURE_CUBE_MAP_POSITIVE_X+z:i.TEXTURE_2D,be=y.depthTexture.format===Ms?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(y.depthTexture.format===_s)ye(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,be,re,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,be,re,ve,0);else if(y.depthTexture.format===Ms)ye(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,be,re,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,be,re,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Se(A){let y=n.get(A),z=A.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==A.depthTexture){let se=A.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),se){let Q=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,se.removeEventListener("dispose",Q)};se.addEventListener("dispose",Q),y.__depthDisposeCallback=Q}y.__boundDepthTexture=se}if(A.depthTexture&&!y.__autoAllocateDepthBuffer)if(z)for(let se=0;se<6;se++)xe(y.__webglFramebuffer[se],A,se);else A.texture.mipmaps.length>0?xe(y.__webglFramebuffer[0],A,0):xe(y.__webglFramebuffer,A,0);else if(z){y.__webglDepthbuffer=[];for(let se=0;se<6;se++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[se]),y.__webglDepthbuffer[se]===void 0)y.__webglDepthbuffer[se]=i.createRenderbuffer(),de(y.__webglDepthbuffer[se],A,!1);else{let Q=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,me=y.__webglDepthbuffer[se];i.bindRenderbuffer(i.RENDERBUFFER,me),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,me)}}else if(A.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),de(y.__webglDepthbuffer,A,!1);else{let Q=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,me=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,me),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,me)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function _e(A,y,z){let se=n.get(A);y!==void 0&&K(se.__webglFramebuffer,A,A.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&Se(A)}function $e(A){let y=A.texture,z=n.get(A),se=n.get(y);A.addEventListener("dispose",k),B(A);let Q=A.textures,me=A.isWebGLCubeRenderTarget===!0,ve=Q.length>1;if(ve||(se.__webglTexture===void 0&&(se.__webglTexture=i.createTexture()),se.__version=y.version,o.memory.textures++),me){z.__webglFramebuffer=[];for(let te=0;te<6;te++)if(y.mipmaps.length>0){z.__webglFramebuffer[te]=[];for(let re=0;re<y.mipmaps.length;re++)z.__webglFramebuffer[te][re]=i.createFramebuffer()}else z.__webglFramebuffer[te]=i.createFramebuffer()}else{if(y.mipmaps.length>0){z.__webglFramebuffer=[];for(let te=0;te<y.mipmaps.length;te++)z.__webglFramebuffer[te]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(ve)for(let te=0,re=Q.length;te<re;te++){let be=n.get(Q[te]);be.__webglTexture===void 0&&(be.__webglTexture=i.createTexture(),o.memory.textures++)}if(A.samples>0&&ye(A)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let te=0;te<Q.length;te++){let re=Q[te];z.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[te]);let be=r.convert(re.format,re.colorSpace),O=r.convert(re.type),ae=E(re.internalFormat,be,O,re.normalized,re.colorSpace,A.isXRRenderTarget===!0),oe=Ue(A);i.renderbufferStorageMultisample(i.RENDERBUFFER,oe,ae,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,z.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),A.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),de(z.__webglDepthRenderbuffer,A,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(me){t.bindTexture(i.TEXTURE_CUBE_MAP,se.__webglTexture),ft(i.TEXTURE_CUBE_MAP,y);for(let te=0;te<6;te++)if(y.mipmaps.length>0)for(let re=0;re<y.mipmaps.length;re++)K(z.__webglFramebuffer[te][re],A,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,re);else K(z.__webglFramebuffer[te],A,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(y)?v(i.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,re=Q.length;te<re;te++){let be=Q[te],O=n.get(be),ae=i.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(ae=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,O.__webglTexture),ft(ae,be),K(z.__webglFramebuffer,A,be,i.COLOR_ATTACHMENT0+te,ae,0),C(be)&&v(ae)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(te=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,se.__webglTexture),ft(te,y),y.mipmaps.length>0)for(let re=0;re<y.mipmaps.length;re++)K(z.__webglFramebuffer[re],A,y,i.COLOR_ATTACHMENT0,te,re);else K(z.__webglFramebuffer,A,y,i.COLOR_ATTACHMENT0,te,0);C(y)?v(te):y.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}A.depthBuffer&&Se(A)}function P(A){let y=A.textures;for(let z=0,se=y.length;z<se;z++){let Q=y[z];if(C(Q)&&Q.mipmapsAutoUpdate===!0){let me=R(A),ve=n.get(Q).__webglTexture;t.bindTexture(me,ve),v(me),t.unbindTexture()}}}let ue=[];function ze(A){if(A.samples>0){if(ye(A)===!1){let y=A.textures,z=A.width,se=A.height,Q=i.COLOR_BUFFER_BIT,me=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(A),te=y.length>1;if(te)for(let be=0;be<y.length;be++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let be=0;be<y.length;be++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[be]);let O=n.get(y[be]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,z,se,0,0,z,se,Q,i.NEAREST),l===!0&&(ue.length=0,ue.push(i.COLOR_ATTACHMENT0+be),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&ue.push(me),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ue))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let be=0;be<y.length;be++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.RENDERBUFFER,ve.__webglColorRenderbuffer[be]);let O=n.get(y[be]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.TEXTURE_2D,O,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let y=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function Ue(A){return Math.min(s.maxSamples,A.samples)}function ye(A){let y=n.get(A);return A.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function qe(A){let y=o.render.frame;h.get(A)!==y&&(h.set(A,y),A.update())}function Te(A,y){let z=A.colorSpace,se=A.format,Q=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||z!==la&&z!==Ss&&(At.getTransfer(z)===Ut?(se!==ki||Q!==Kn)&&rt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ht("WebGLTextures: Unsupported texture color space:",z)),y}function Ge(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=pe,this.setTexture2D=ge,this.setTexture2DArray=Me,this.setTexture3D=Le,this.setTextureCube=Ee,this.rebindTextures=_e,this.setupRenderTarget=$e,this.updateRenderTargetMipmap=P,this.updateMultisampleRenderTarget=ze,this.setupDepthRenderbuffer=Se,this.setupFrameBufferTexture=K,this.useMultisampledRTT=ye,this.dispose=H}function fT(i,e){function t(n,s=Ss){let r,o=At.getTransfer(s);if(n===Kn)return i.UNSIGNED_BYTE;if(n===Uc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Oc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ed)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Cd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Td)return i.BYTE;if(n===Ad)return i.SHORT;if(n===Po)return i.UNSIGNED_SHORT;if(n===Nc)return i.INT;if(n===Oi)return i.UNSIGNED_INT;if(n===Fi)return i.FLOAT;if(n===Bi)return i.HALF_FLOAT;if(n===Rd)return i.ALPHA;if(n===Pd)return i.RGB;if(n===ki)return i.RGBA;if(n===_s)return i.DEPTH_COMPONENT;if(n===Ms)return i.DEPTH_STENCIL;if(n===Id)return i.RED;if(n===Fc)return i.RED_INTEGER;if(n===Zs)return i.RG;if(n===Bc)return i.RG_INTEGER;if(n===kc)return i.RGBA_INTEGER;if(n===Ia||n===La||n===Da||n===Na)if(o===Ut)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ia)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Na)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ia)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Da)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Na)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===zc||n===Gc||n===Hc||n===Vc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Gc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Hc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Vc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Wc||n===Xc||n===qc||n===Yc||n===$c||n===Ua||n===Zc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Wc||n===Xc)return o===Ut?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===qc)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Yc)return r.COMPRESSED_R11_EAC;if(n===$c)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ua)return r.COMPRESSED_RG11_EAC;if(n===Zc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Jc||n===Kc||n===jc||n===Qc||n===eh||n===th||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Jc)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Kc)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===jc)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Qc)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===eh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===th)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===nh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ih)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===sh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===rh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===oh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ah)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===lh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ch)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===hh||n===uh||n===dh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===hh)return o===Ut?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===dh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===fh||n===ph||n===Oa||n===mh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===fh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===ph)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Oa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===yr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var pT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,mT=`
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

}`,Qd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ya(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Qi({vertexShader:pT,fragmentShader:mT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new tn(new fr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ef=class extends Li{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,M=typeof XRWebGLBinding<"u",m=new Qd,p={},b=t.getContextAttributes(),C=null,v=null,R=[],E=[],_=new Xe,T=null,B=null,N=new Xn;N.viewport=new Rt;let D=new Xn;D.viewport=new Rt;let k=[N,D],W=new Rc,L=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=R[ee];return ge===void 0&&(ge=new xo,R[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=R[ee];return ge===void 0&&(ge=new xo,R[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=R[ee];return ge===void 0&&(ge=new xo,R[ee]=ge),ge.getHandSpace()};function q(ee){let ge=E.indexOf(ee.inputSource);if(ge===-1)return;let Me=R[ge];Me!==void 0&&(Me.update(ee.inputSource,ee.frame,c||o),Me.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let ge=E[ee];ge!==null&&(E[ee]=null,R[ee].disconnect(ge))}L=null,H=null,m.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(C),f=null,d=null,u=null,s=null,v=null,he.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(_.width,_.height,!1),B!==null){let ee=B.camera;ee.fov=B.fov,ee.zoom=B.zoom,ee.updateProjectionMatrix(),B=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&rt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&rt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&M&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ce),b.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(_),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let Me=null,Le=null,Ee=null;b.depth&&(Ee=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Me=b.stencil?Ms:_s,Le=b.stencil?yr:Oi);let je={colorFormat:t.RGBA8,depthFormat:Ee,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(je),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new ci(d.textureWidth,d.textureHeight,{format:ki,type:Kn,depthTexture:new vs(d.textureWidth,d.textureHeight,Le,void 0,void 0,void 0,void 0,void 0,void 0,Me),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Me={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Me),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new ci(f.framebufferWidth,f.framebufferHeight,{format:ki,type:Kn,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ce(ee){for(let ge=0;ge<ee.removed.length;ge++){let Me=ee.removed[ge],Le=E.indexOf(Me);Le>=0&&(E[Le]=null,R[Le].disconnect(Me))}for(let ge=0;ge<ee.added.length;ge++){let Me=ee.added[ge],Le=E.indexOf(Me);if(Le===-1){for(let je=0;je<R.length;je++)if(je>=E.length){E.push(Me),Le=je;break}else if(E[je]===null){E[je]=Me,Le=je;break}if(Le===-1)break}let Ee=R[Le];Ee&&Ee.connect(Me)}}function Y(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,Me=ee.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(Me=m.depthFar)),W.near=D.near=N.near=ge,W.far=D.far=N.far=Me,(L!==W.near||H!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),L=W.near,H=W.far),W.layers.mask=ee.layers.mask|6,N.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Le=ee.parent,Ee=W.cameras;Y(W,Le);for(let je=0;je<Ee.length;je++)Y(Ee[je],Le);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),B===null&&ee.isPerspectiveCamera&&(B={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,W,Le)};function j(ee,ge,Me){Me===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(Me.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=mo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(ee){return p[ee]};let ie=null;function pe(ee,ge){if(h=ge.getViewerPose(c||o),g=ge,h!==null){let Me=h.views;f!==null&&(e.setRenderTargetFramebuffer(v,f.framebuffer),e.setRenderTarget(v));let Le=!1;Me.length!==W.cameras.length&&(W.cameras.length=0,Le=!0);for(let Je=0;Je<Me.length;Je++){let ft=Me[Je],pt=null;if(f!==null)pt=f.getViewport(ft);else{let Ot=u.getViewSubImage(d,ft);pt=Ot.viewport,Je===0&&(e.setRenderTargetTextures(v,Ot.colorTexture,Ot.depthStencilTexture),e.setRenderTarget(v))}let ot=k[Je];ot===void 0&&(ot=new Xn,ot.layers.enable(Je),ot.viewport=new Rt,k[Je]=ot),ot.matrix.fromArray(ft.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(ft.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(pt.x,pt.y,pt.width,pt.height),Je===0&&(W.matrix.copy(ot.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Le===!0&&W.cameras.push(ot)}let Ee=s.enabledFeatures;if(Ee&&Ee.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){u=n.getBinding();let Je=u.getDepthInformation(Me[0]);Je&&Je.isValid&&Je.texture&&m.init(Je,s.renderState)}if(Ee&&Ee.includes("camera-access")&&M){e.state.unbindTexture(),u=n.getBinding();for(let Je=0;Je<Me.length;Je++){let ft=Me[Je].camera;if(ft){let pt=p[ft];pt||(pt=new ya,p[ft]=pt);let ot=u.getCameraImage(ft);pt.sourceTexture=ot}}}}for(let Me=0;Me<R.length;Me++){let Le=E[Me],Ee=R[Me];Le!==null&&Ee!==void 0&&Ee.update(Le,ge,c||o)}ie&&ie(ee,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),g=null}let he=new v0;he.setAnimationLoop(pe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},gT=new gt,P0=new at;P0.set(-1,0,0,0,1,0,0,0,1);function _T(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Gd(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,b,C,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,v)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),M(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,b,C):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===$n&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===$n&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let b=e.get(p),C=b.envMap,v=b.envMapRotation;C&&(m.envMap.value=C,m.envMapRotation.value.setFromMatrix4(gT.makeRotationFromEuler(v)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(P0),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,b,C){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*b,m.scale.value=C*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,b){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===$n&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=b.texture,m.transmissionSamplerSize.value.set(b.width,b.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function M(m,p){let b=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(b.matrixWorld),m.nearDistance.value=b.shadow.camera.near,m.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function xT(i,e,t,n){let s={},r={};function o(b,C){let v=C.program;n.uniformBlockBinding(b,v,s[b.id])}function a(b,C){let v=s[b.id];v===void 0&&(g(b),v=l(b),s[b.id]=v,b.addEventListener("dispose",m));let R=C.program;n.updateUBOMapping(b,R);let E=e.render.frame;r[b.id]!==E&&(c(b),r[b.id]=E)}function l(b){let C=i.createBuffer(),v=b.__size,R=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,v,R),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(b){let C=s[b.id],v=b.uniforms,R=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let E=0,_=v.length;E<_;E++){let T=v[E];if(Array.isArray(T))for(let B=0,N=T.length;B<N;B++)h(T[B],E,B,R);else h(T,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(b,C,v,R){if(d(b,C,v,R)===!0){let E=b.__offset,_=b.value;if(Array.isArray(_)){let T=0;for(let B=0;B<_.length;B++){let N=_[B],D=M(N,!0);u(N,b.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,b.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,b.__data)}}function u(b,C,v){typeof b=="number"||typeof b=="boolean"?C[v]=b:b.isMatrix3?(C[v]=b.elements[0],C[v+1]=b.elements[1],C[v+2]=b.elements[2],C[v+3]=0,C[v+4]=b.elements[3],C[v+5]=b.elements[4],C[v+6]=b.elements[5],C[v+7]=0,C[v+8]=b.elements[6],C[v+9]=b.elements[7],C[v+10]=b.elements[8],C[v+11]=0):ArrayBuffer.isView(b)?C.set(b.subarray(0,C.length-v),v):b.toArray(C,v)}function d(b,C,v,R){let E=b.value,_=C+"_"+v;if(Array.isArray(E)){R[_]===void 0&&(R[_]=[]);let T=R[_],B=!1;for(let N=0;N<E.length;N++)f(E[N],T,N)===!0&&(B=!0);return B}return f(E,R,_)}function f(b,C,v){if(C[v]===void 0)return typeof b=="number"||typeof b=="boolean"?C[v]=b:ArrayBuffer.isView(b)?C[v]=b.slice():C[v]=b.clone(),!0;{let R=C[v];if(typeof b=="number"||typeof b=="boolean"){if(R!==b)return C[v]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(R.equals(b)===!1)return R.copy(b),!0}}return!1}function g(b){let C=b.uniforms,v=0,R=16;for(let _=0,T=C.length;_<T;_++){let B=Array.isArray(C[_])?C[_]:[C[_]];for(let N=0,D=B.length;N<D;N++){let k=B[N],W=Array.isArray(k.value)?k.value:[k.value],L=Array.isArray(C[_])||Array.isArray(k.value),H=v;for(let V=0,ce=W.length;V<ce;V++){let Y=W[V],j=M(Y,L),ie=v%R,pe=ie%j.boundary,he=ie+pe;v+=pe,he!==0&&R-he<j.storage&&(v+=R-he),V===0&&(H=v),v+=j.storage}let q=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new q((v-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let E=v%R;return E>0&&(v+=R-E),b.__size=v,b.__cache={},this}function M(b,C){let v={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(v.boundary=4,v.storage=4):b.isVector2?(v.boundary=8,v.storage=8):b.isVector3||b.isColor?(v.boundary=16,v.storage=12):b.isVector4?(v.boundary=16,v.storage=16):b.isMatrix3?(v.boundary=16,v.storage=48):b.isMatrix4?(v.boundary=16,v.storage=64):b.isTexture?rt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(v.boundary=16,v.storage=b.byteLength):rt("WebGLRenderer: Unsupported uniform value type.",b),C===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(b){let C=b.target;C.removeEventListener("dispose",m),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function p(){for(let b in s)i.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:p}}var yT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ts=null;function vT(){return ts===null&&(ts=new uc(yT,16,16,Zs,Bi),ts.name="DFG_LUT",ts.minFilter=qn,ts.magFilter=qn,ts.wrapS=Ji,ts.wrapT=Ji,ts.generateMipmaps=!1,ts.needsUpdate=!0),ts}var za=class{constructor(e={}){let{canvas:t=Wg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let M=f,m=new Set([kc,Bc,Fc]),p=new Set([Kn,Oi,Po,yr,Uc,Oc]),b=new Uint32Array(4),C=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},R=null,E=null,_=[],T=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,D=!1,k=null,W=null,L=null,H=null;this._outputColorSpace=Vn;let q=0,V=0,ce=null,Y=-1,j=null,ie=new Rt,pe=new Rt,he=null,ee=new nt(0),ge=0,Me=t.width,Le=t.height,Ee=1,je=null,ut=null,Je=new Rt(0,0,Me,Le),ft=new Rt(0,0,Me,Le),pt=!1,ot=new ji,Ot=new dc,Dt=!1,qt=!1,K=new gt,de=new F,xe=new Rt,Se={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_e=!1;function $e(){return ce===null?Ee:1}let P=n;function ue(w,G){return t.getContext(w,G)}let ze,Ue,ye,qe,Te,Ge,A,y,z,se,Q,me,ve,te,re,be,O,ae,oe,Pe,Ae,Re,Qe;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Fe,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),P===null){let G="webgl2";if(P=ue(G,w),P===null)throw ue(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}st()}catch(w){throw t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),ht("WebGLRenderer: "+w.message),w}function st(){ze=new IS(P),ze.init(),Ae=new fT(P,ze),Ue=new vS(P,ze,e,Ae),ye=new uT(P,ze),Ue.reversedDepthBuffer&&d&&ye.buffers.depth.setReversed(!0),W=P.createFramebuffer(),L=P.createFramebuffer(),H=P.createFramebuffer(),qe=new NS(P),Te=new Kw,Ge=new dT(P,ze,ye,Te,Ue,Ae,qe),A=new PS(N),y=new Ov(P),Re=new xS(P,y),z=new LS(P,y,qe,Re),se=new OS(P,z,y,Re,qe),ae=new US(P,Ue,Ge),re=new bS(Te),Q=new Jw(N,A,ze,Ue,Re,re),me=new _T(N,Te),ve=new Qw,te=new rT(ze),O=new _S(N,A,ye,se,g,l),be=new hT(N,se,Ue),Qe=new xT(P,qe,Ue,ye),oe=new yS(P,ze,qe),Pe=new DS(P,ze,qe),qe.programs=Q.programs,N.capabilities=Ue,N.extensions=ze,N.properties=Te,N.renderLists=ve,N.shadowMap=be,N.state=ye,N.info=qe}M!==Kn&&(B=new BS(M,t.width,t.height,a,s,r));let le=new ef(N,P);this.xr=le,this.getContext=function(){return P},this.getContextAttributes=function(){return P.getContextAttributes()},this.forceContextLoss=function(){let w=ze.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=ze.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Ee},this.setPixelRatio=function(w){w!==void 0&&(Ee=w,this.setSize(Me,Le,!1))},this.getSize=function(w){return w.set(Me,Le)},this.setSize=function(w,G,ne=!0){if(le.isPresenting){rt("WebGLRenderer: Can't change size while VR device is presenting.");return}Me=w,Le=G,t.width=Math.floor(w*Ee),t.height=Math.floor(G*Ee),ne===!0&&(t.style.width=w+"px",t.style.height=G+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,w,G)},this.getDrawingBufferSize=function(w){return w.set(Me*Ee,Le*Ee).floor()},this.setDrawingBufferSize=function(w,G,ne){Me=w,Le=G,Ee=ne,t.width=Math.floor(w*ne),t.height=Math.floor(G*ne),this.setViewport(0,0,w,G)},this.setEffects=function(w){if(M===Kn){ht("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let G=0;G<w.length;G++)if(w[G].isOutputPass===!0){rt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(Je)},this.setViewport=function(w,G,ne,$){w.isVector4?Je.set(w.x,w.y,w.z,w.w):Je.set(w,G,ne,$),ye.viewport(ie.copy(Je).multiplyScalar($e()).round())},this.getScissor=function(w){return w.copy(ft)},this.setScissor=function(w,G,ne,$){w.isVector4?ft.set(w.x,w.y,w.z,w.w):ft.set(w,G,ne,$),ye.scissor(pe.copy(ft).multiplyScalar($e()).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(w){ye.setScissorTest(pt=w)},this.setOpaqueSort=function(w){je=w},this.setTransparentSort=function(w){ut=w},this.getClearColor=function(w){return w.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(w=!0,G=!0,ne=!0){let $=0;if(w){let Z=!1;if(ce!==null){let De=ce.texture.format;Z=m.has(De)}if(Z){let De=ce.texture.type,Oe=p.has(De),Ne=O.getClearColor(),Be=O.getClearAlpha(),Ke=Ne.r,dt=Ne.g,vt=Ne.b;Oe?(b[0]=Ke,b[1]=dt,b[2]=vt,b[3]=Be,P.clearBufferuiv(P.COLOR,0,b)):(C[0]=Ke,C[1]=dt,C[2]=vt,C[3]=Be,P.clearBufferiv(P.COLOR,0,C))}else $|=P.COLOR_BUFFER_BIT}G&&($|=P.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&($|=P.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&P.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),k=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ve.dispose(),te.dispose(),Ge.dispose(),Te.dispose(),A.dispose(),se.dispose(),z.dispose(),Re.dispose(),Qe.dispose(),Q.dispose(),le.dispose(),le.removeEventListener("sessionstart",Ja),le.removeEventListener("sessionend",zi),is.stop()};function Fe(w){w.preventDefault(),ua("WebGLRenderer: Context Lost."),D=!0}function tt(){ua("WebGLRenderer: Context Restored."),D=!1;let w=qe.autoReset,G=be.enabled,ne=be.autoUpdate,$=be.needsUpdate,Z=be.type;st(),qe.autoReset=w,be.enabled=G,be.autoUpdate=ne,be.needsUpdate=$,be.type=Z}function Ce(w){ht("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function lt(w){let G=w.target;G.removeEventListener("dispose",lt),Gt(G)}function Gt(w){Ln(w),Te.remove(w)}function Ln(w){let G=Te.get(w).programs;G!==void 0&&(G.forEach(function(ne){Q.releaseProgram(ne)}),w.isShaderMaterial&&Q.releaseShaderCache(w))}this.renderBufferDirect=function(w,G,ne,$,Z,De){G===null&&(G=Se);let Oe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ne=Oo(w,G,ne,$,Z);ye.setMaterial($,Oe);let Be=ne.index,Ke=1;if($.wireframe===!0){if(Be=z.getWireframeAttribute(ne),Be===void 0)return;Ke=2}let dt=ne.drawRange,vt=ne.attributes.position,Ze=dt.start*Ke,bt=(dt.start+dt.count)*Ke;De!==null&&(Ze=Math.max(Ze,De.start*Ke),bt=Math.min(bt,(De.start+De.count)*Ke)),Be!==null?(Ze=Math.max(Ze,0),bt=Math.min(bt,Be.count)):vt!=null&&(Ze=Math.max(Ze,0),bt=Math.min(bt,vt.count));let Qt=bt-Ze;if(Qt<0||Qt===1/0)return;Re.setup(Z,$,Ne,ne,Be);let Ft,Bt=oe;if(Be!==null&&(Ft=y.get(Be),Bt=Pe,Bt.setIndex(Ft)),Z.isMesh)$.wireframe===!0?(ye.setLineWidth($.wireframeLinewidth*$e()),Bt.setMode(P.LINES)):Bt.setMode(P.TRIANGLES);else if(Z.isLine){let mn=$.linewidth;mn===void 0&&(mn=1),ye.setLineWidth(mn*$e()),Z.isLineSegments?Bt.setMode(P.LINES):Z.isLineLoop?Bt.setMode(P.LINE_LOOP):Bt.setMode(P.LINE_STRIP)}else Z.isPoints?Bt.setMode(P.POINTS):Z.isSprite&&Bt.setMode(P.TRIANGLES);if(Z.isBatchedMesh)if(ze.get("WEBGL_multi_draw"))Bt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let mn=Z._multiDrawStarts,We=Z._multiDrawCounts,cn=Z._multiDrawCount,wt=Be?y.get(Be).bytesPerElement:1,rs=Te.get($).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)rs.setValue(P,"_gl_DrawID",hn),Bt.render(mn[hn]/wt,We[hn])}else if(Z.isInstancedMesh)Bt.renderInstances(Ze,Qt,Z.count);else if(ne.isInstancedBufferGeometry){let mn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,We=Math.min(ne.instanceCount,mn);Bt.renderInstances(Ze,Qt,We)}else Bt.render(Ze,Qt)};function Do(w,G,ne,$){k!==null&&w.isNodeMaterial&&k.setObject($,w),Dt===!0&&re.setState(w,ne,!1),w.transparent===!0&&w.side===Zn&&w.forceSinglePass===!1?(w.side=$n,w.needsUpdate=!0,Gi(w,G,$),w.side=$s,w.needsUpdate=!0,Gi(w,G,$),w.side=Zn):Gi(w,G,$)}this.compile=function(w,G,ne=null){ne===null&&(ne=w),k!==null&&k.renderStart(w,G,ne),E=te.get(ne),E.init(G),T.push(E),ne.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),w!==ne&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),k!==null&&k.updateLights(E.state.lightsArray),qt=this.localClippingEnabled,Dt=re.init(this.clippingPlanes,qt),Dt===!0&&re.setGlobalState(this.clippingPlanes,G),k!==null&&be.render(E.state.shadowsArray,ne,G);let $=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let De=Z.material;if(De)if(Array.isArray(De))for(let Oe=0;Oe<De.length;Oe++){let Ne=De[Oe];Do(Ne,ne,G,Z),$.add(Ne)}else Do(De,ne,G,Z),$.add(De)}),E=T.pop(),k!==null&&k.renderEnd(),$},this.compileAsync=function(w,G,ne=null){let $=this.compile(w,G,ne);return new Promise(Z=>{function De(){if($.forEach(function(Oe){let Be=Te.get(Oe).currentProgram;(Be===void 0||Be.isReady())&&$.delete(Oe)}),$.size===0){Z(w);return}setTimeout(De,10)}ze.get("KHR_parallel_shader_compile")!==null?De():setTimeout(De,10)})};let Mr=null;function Vh(w){Mr&&Mr(w)}function Ja(){is.stop()}function zi(){is.start()}let is=new v0;is.setAnimationLoop(Vh),typeof self<"u"&&is.setContext(self),this.setAnimationLoop=function(w){Mr=w,le.setAnimationLoop(w),w===null?is.stop():is.start()},le.addEventListener("sessionstart",Ja),le.addEventListener("sessionend",zi),this.render=function(w,G){if(G!==void 0&&G.isCamera!==!0){ht("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;k!==null&&k.renderStart(w,G);let ne=le.enabled===!0&&le.isPresenting===!0,$=B!==null&&(ce===null||ne)&&B.begin(N,ce);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(G),G=le.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,G,ce),E=te.get(w,T.length),E.init(G),E.state.textureUnits=Ge.getTextureUnits(),T.push(E),K.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Ot.setFromArrayCamera(G):ot.setFromProjectionMatrix(K,vi,G.reversedDepth),qt=this.localClippingEnabled,Dt=re.init(this.clippingPlanes,qt),R=ve.get(w,_.length),R.init(),_.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Oe=N.xr.getDepthSensingMesh();Oe!==null&&ss(Oe,G,-1/0,N.sortObjects)}ss(w,G,0,N.sortObjects),R.finish(),k!==null&&k.updateLights(E.state.lightsArray),N.sortObjects===!0&&R.sort(je,ut),_e=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,_e&&O.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Dt===!0&&re.beginShadows();let Z=E.state.shadowsArray;if(be.render(Z,w,G),Dt===!0&&re.endShadows(),($&&B.hasRenderPass())===!1){let Oe=R.opaque,Ne=R.transmissive;if(E.setupLights(),G.isArrayCamera){let Be=G.cameras;if(Ne.length>0)for(let Ke=0,dt=Be.length;Ke<dt;Ke++){let vt=Be[Ke];Si(Oe,Ne,w,vt)}_e&&O.render(w);for(let Ke=0,dt=Be.length;Ke<dt;Ke++){let vt=Be[Ke];No(R,w,vt,vt.viewport)}}else Ne.length>0&&Si(Oe,Ne,w,G),_e&&O.render(w),No(R,w,G)}ce!==null&&V===0&&(Ge.updateMultisampleRenderTarget(ce),Ge.updateRenderTargetMipmap(ce)),$&&B.end(N),w.isScene===!0&&w.onAfterRender(N,w,G),Re.resetDefaultState(),Y=-1,j=null,T.pop(),T.length>0?(E=T[T.length-1],Ge.setTextureUnits(E.state.textureUnits),Dt===!0&&re.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,k!==null&&k.renderEnd()};function ss(w,G,ne,$){if(w.visible===!1)return;if(w.layers.test(G.layers)){if(w.isGroup)ne=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(G);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Oe=G.isArrayCamera?Ot:ot;if(!w.frustumCulled||w.intersectsFrustum(Oe)){$&&xe.setFromMatrixPosition(w.matrixWorld).applyMatrix4(K);let Ne=se.update(w),Be=w.material;Be.visible&&R.push(w,Ne,Be,ne,xe.z,null,G)}}else if(w.isMesh||w.isLine||w.isPoints){let Oe=G.isArrayCamera?Ot:ot;if(!w.frustumCulled||w.intersectsFrustum(Oe)){let Ne=se.update(w),Be=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xe.copy(w.boundingSphere.center)):(Ne.boundingSphere===null&&Ne.computeBoundingSphere(),xe.copy(Ne.boundingSphere.center)),xe.applyMatrix4(w.matrixWorld).applyMatrix4(K)),Array.isArray(Be)){let Ke=Ne.groups;for(let dt=0,vt=Ke.length;dt<vt;dt++){let Ze=Ke[dt],bt=Be[Ze.materialIndex];bt&&bt.visible&&R.push(w,Ne,bt,ne,xe.z,Ze,G)}}else Be.visible&&R.push(w,Ne,Be,ne,xe.z,null,G)}}}let De=w.children;for(let Oe=0,Ne=De.length;Oe<Ne;Oe++)ss(De[Oe],G,ne,$)}function No(w,G,ne,$){let{opaque:Z,transmissive:De,transparent:Oe}=w;E.setupLightsView(ne),Dt===!0&&re.setGlobalState(N.clippingPlanes,ne),$&&ye.viewport(ie.copy($)),Z.length>0&&nn(Z,G,ne),De.length>0&&nn(De,G,ne),Oe.length>0&&nn(Oe,G,ne),ye.buffers.depth.setTest(!0),ye.buffers.depth.setMask(!0),ye.buffers.color.setMask(!0),ye.setPolygonOffset(!1)}function Si(w,G,ne,$){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[$.id]===void 0){let Ze=ze.has("EXT_color_buffer_half_float")||ze.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[$.id]=new ci(1,1,{generateMipmaps:!0,type:Ze?Bi:Kn,minFilter:bs,samples:Math.max(4,Ue.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:At.workingColorSpace})}let De=E.state.transmissionRenderTarget[$.id],Oe=$.viewport||ie;De.setSize(Oe.z*N.transmissionResolutionScale,Oe.w*N.transmissionResolutionScale);let Ne=N.getRenderTarget(),Be=N.getActiveCubeFace(),Ke=N.getActiveMipmapLevel();N.setRenderTarget(De),N.getClearColor(ee),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),_e&&O.render(ne);let dt=N.toneMapping;N.toneMapping=es;let vt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),E.setupLightsView($),Dt===!0&&re.setGlobalState(N.clippingPlanes,$),nn(w,ne,$),Ge.updateMultisampleRenderTarget(De),Ge.updateRenderTargetMipmap(De),ze.has("WEBGL_multisampled_render_to_texture")===!1){let Ze=!1;for(let bt=0,Qt=G.length;bt<Qt;bt++){let Ft=G[bt],{object:Bt,geometry:mn,material:We,group:cn}=Ft;if(We.side===Zn&&Bt.layers.test($.layers)){let wt=We.side;We.side=$n,We.needsUpdate=!0,an(Bt,ne,$,mn,We,cn),We.side=wt,We.needsUpdate=!0,Ze=!0}}Ze===!0&&(Ge.updateMultisampleRenderTarget(De),Ge.updateRenderTargetMipmap(De))}N.setRenderTarget(Ne,Be,Ke),N.setClearColor(ee,ge),vt!==void 0&&($.viewport=vt),N.toneMapping=dt}function nn(w,G,ne){let $=G.isScene===!0?G.overrideMaterial:null;for(let Z=0,De=w.length;Z<De;Z++){let Oe=w[Z],{object:Ne,geometry:Be,group:Ke}=Oe,dt=Oe.material;dt.allowOverride===!0&&$!==null&&(dt=$),Ne.layers.test(ne.layers)&&an(Ne,G,ne,Be,dt,Ke)}}function an(w,G,ne,$,Z,De){k!==null&&Z.isNodeMaterial&&k.setObject(w,Z),w.onBeforeRender(N,G,ne,$,Z,De),w.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(N,G,ne,$,w,De),Z.transparent===!0&&Z.side===Zn&&Z.forceSinglePass===!1?(Z.side=$n,Z.needsUpdate=!0,N.renderBufferDirect(ne,G,$,Z,w,De),Z.side=$s,Z.needsUpdate=!0,N.renderBufferDirect(ne,G,$,Z,w,De),Z.side=Zn):N.renderBufferDirect(ne,G,$,Z,w,De),w.onAfterRender(N,G,ne,$,Z,De)}function ln(w){let G=0;for(let ne of w)ne.texture!==null&&G++;return G}function Gi(w,G,ne){G.isScene!==!0&&(G=Se);let $=Te.get(w),Z=E.state.lights,De=E.state.shadowsArray,Oe=Z.state.version,Ne=Q.getParameters(w,Z.state,De,G,ne,E.state.lightProbeGridArray),Be=Q.getProgramCacheKey(Ne),Ke=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?G.environment:null,$.fog=G.fog;let dt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=A.get(w.envMap||$.environment,dt),$.envMapRotation=$.environment!==null&&w.envMap===null?G.environmentRotation:w.envMapRotation,Ke===void 0&&(w.addEventListener("dispose",lt),Ke=new Map,$.programs=Ke,$.programVariants=new Map);let vt=Ke.get(Be);if(vt!==void 0){if($.currentProgram===vt&&$.lightsStateVersion===Oe)return Uo(w,Ne),vt}else Ne.uniforms=Q.getUniforms(w),k!==null&&w.isNodeMaterial&&k.build(w,ne,Ne),w.onBeforeCompile(Ne,N),vt=Q.acquireProgram(Ne,Be),Ke.set(Be,vt),$.uniforms=Ne.uniforms;let Ze=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ze.clippingPlanes=re.uniform),Uo(w,Ne),$.needsLights=Rs(w),$.lightsStateVersion=Oe,$.needsLights&&(Ze.ambientLightColor.value=Z.state.ambient,Ze.lightProbe.value=Z.state.probe,Ze.sunLights.value=Z.state.sun,Ze.sunLightShadows.value=Z.state.sunShadow,Ze.directionalLights.value=Z.state.directional,Ze.directionalLightShadows.value=Z.state.directionalShadow,Ze.spotLights.value=Z.state.spot,Ze.spotLightShadows.value=Z.state.spotShadow,Ze.rectAreaLights.value=Z.state.rectArea,Ze.ltc_1.value=Z.state.rectAreaLTC1,Ze.ltc_2.value=Z.state.rectAreaLTC2,Ze.pointLights.value=Z.state.point,Ze.pointLightShadows.value=Z.state.pointShadow,Ze.hemisphereLights.value=Z.state.hemi,Ze.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ze.sunShadowCascade.value=Z.state.sunShadowCascade,Ze.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ze.spotLightMatrix.value=Z.state.spotLightMatrix,Ze.spotLightMap.value=Z.state.spotLightMap,Ze.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=ln(E.state.lightProbeGridArray),$.currentProgram=vt,$.uniformsList=null,vt}function Qn(w,G,ne,$,Z){let De=Te.get(w),Oe=De.currentProgram.id+","+$+","+Z,Ne=De.programVariants.get(Oe);return Ne===void 0?(Ne=Gi(w,G,ne),De.programVariants.set(Oe,Ne)):(De.currentProgram=Ne,De.uniformsList=null,De.outputColorSpace=$,De.toneMapping=Z),Ne}function Cs(w){if(w.uniformsList===null){let G=w.currentProgram.getUniforms();w.uniformsList=Io.seqWithValue(G.seq,w.uniforms)}return w.uniformsList}function Uo(w,G){let ne=Te.get(w);ne.outputColorSpace=G.outputColorSpace,ne.batching=G.batching,ne.batchingColor=G.batchingColor,ne.instancing=G.instancing,ne.instancingColor=G.instancingColor,ne.instancingMorph=G.instancingMorph,ne.skinning=G.skinning,ne.morphTargets=G.morphTargets,ne.morphNormals=G.morphNormals,ne.morphColors=G.morphColors,ne.morphTargetsCount=G.morphTargetsCount,ne.numClippingPlanes=G.numClippingPlanes,ne.numIntersection=G.numClipIntersection,ne.vertexAlphas=G.vertexAlphas,ne.vertexTangents=G.vertexTangents,ne.toneMapping=G.toneMapping}function Oo(w,G,ne,$,Z){G.isScene!==!0&&(G=Se),Ge.resetTextureUnits();let De=G.fog,Oe=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?G.environment:null,Ne=ce===null?N.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:At.workingColorSpace,Be=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ke=A.get($.envMap||Oe,Be),dt=$.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,vt=!!ne.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ze=!!ne.morphAttributes.position,bt=!!ne.morphAttributes.normal,Qt=!!ne.morphAttributes.color,Ft=es;$.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ft=N.toneMapping);let Bt=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,mn=Bt!==void 0?Bt.length:0,We=Te.get($),cn=E.state.lights;if(Dt===!0&&(qt===!0||w!==j)){let kt=w===j&&$.id===Y;re.setState($,w,kt)}let wt=!1,rs=!1;$.version===We.__version?We.needsLights&&We.lightsStateVersion!==cn.state.version||Z.isBatchedMesh&&We.batching===!1||!Z.isBatchedMesh&&We.batching===!0||Z.isBatchedMesh&&We.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&We.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&We.instancing===!1||!Z.isInstancedMesh&&We.instancing===!0||Z.isSkinnedMesh&&We.skinning===!1||!Z.isSkinnedMesh&&We.skinning===!0||Z.isInstancedMesh&&We.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&We.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&We.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&We.instancingMorph===!1&&Z.morphTexture!==null||We.envMap!==Ke||$.fog===!0&&We.fog!==De||We.numClippingPlanes!==void 0&&(We.numClippingPlanes!==re.numPlanes||We.numIntersection!==re.numIntersection)||We.vertexAlphas!==dt||We.vertexTangents!==vt||We.morphTargets!==Ze||We.morphNormals!==bt||We.morphColors!==Qt||We.morphTargetsCount!==mn||We.numLightProbeGrids!==ln(E.state.lightProbeGridArray)?wt=!0:(We.outputColorSpace!==Ne||We.toneMapping!==Ft)&&(rs=!0):(wt=!0,We.__version=$.version);let hn=We.currentProgram;(wt===!0||rs===!0)&&(hn=rs===!0?Qn($,G,Z,Ne,Ft):Gi($,G,Z),k&&$.isNodeMaterial&&k.onUpdateProgram($,hn,We));let Tr=!1,Hi=!1,os=!1,_t=hn.getUniforms(),sn=We.uniforms;if(ye.useProgram(hn.program)&&(Tr=!0,Hi=!0,os=!0),$.id!==Y&&(Y=$.id,Hi=!0),Tr||j!==w){ye.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),_t.setValue(P,"projectionMatrix",w.projectionMatrix),_t.setValue(P,"viewMatrix",w.matrixWorldInverse);let un=_t.map.cameraPosition;un!==void 0&&un.setValue(P,de.setFromMatrixPosition(w.matrixWorld)),Ue.logarithmicDepthBuffer&&_t.setValue(P,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&_t.setValue(P,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,Hi=!0,os=!0)}if(We.needsLights&&(cn.state.sunShadowMap.length>0&&_t.setValue(P,"sunShadowMap",cn.state.sunShadowMap,Ge),cn.state.directionalShadowMap.length>0&&_t.setValue(P,"directionalShadowMap",cn.state.directionalShadowMap,Ge),cn.state.spotShadowMap.length>0&&_t.setValue(P,"spotShadowMap",cn.state.spotShadowMap,Ge),cn.state.pointShadowMap.length>0&&_t.setValue(P,"pointShadowMap",cn.state.pointShadowMap,Ge)),Z.isSkinnedMesh){_t.setOptional(P,Z,"bindMatrix"),_t.setOptional(P,Z,"bindMatrixInverse");let kt=Z.skeleton;kt&&(kt.boneTexture===null&&kt.computeBoneTexture(),_t.setValue(P,"boneTexture",kt.boneTexture,Ge))}Z.isBatchedMesh&&(_t.setOptional(P,Z,"batchingTexture"),_t.setValue(P,"batchingTexture",Z._matricesTexture,Ge),_t.setOptional(P,Z,"batchingIdTexture"),_t.setValue(P,"batchingIdTexture",Z._indirectTexture,Ge),_t.setOptional(P,Z,"batchingColorTexture"),Z._colorsTexture!==null&&_t.setValue(P,"batchingColorTexture",Z._colorsTexture,Ge));let Fn=ne.morphAttributes;if((Fn.position!==void 0||Fn.normal!==void 0||Fn.color!==void 0)&&ae.update(Z,ne,hn),(Hi||We.receiveShadow!==Z.receiveShadow)&&(We.receiveShadow=Z.receiveShadow,_t.setValue(P,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&G.environment!==null&&(sn.envMapIntensity.value=G.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=vT()),Hi){if(_t.setValue(P,"toneMappingExposure",N.toneMappingExposure),We.needsLights&&Sr(sn,os),De&&$.fog===!0&&me.refreshFogUniforms(sn,De),me.refreshMaterialUniforms(sn,$,Ee,Le,E.state.transmissionRenderTarget[w.id]),We.needsLights&&We.numLightProbeGrids>0){let kt=v,un=0;for(let Dn of E.state.lightProbeGridArray)Dn.texture!==null&&(kt.textures[un]=Dn.texture,kt.min[un]=Dn.boundingBox.min,kt.max[un]=Dn.boundingBox.max,kt.resolution[un]=Dn.resolution,un++);for(let Dn in kt)kt[Dn].length=un;sn.probesSH.value=kt.textures,sn.probesMin.value=kt.min,sn.probesMax.value=kt.max,sn.probesResolution.value=kt.resolution}Io.upload(P,Cs(We),sn,Ge)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Io.upload(P,Cs(We),sn,Ge),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&_t.setValue(P,"center",Z.center),_t.setValue(P,"modelViewMatrix",Z.modelViewMatrix),_t.setValue(P,"normalMatrix",Z.normalMatrix),_t.setValue(P,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let kt=$.uniformsGroups;for(let un=0,Dn=kt.length;un<Dn;un++){let Ka=kt[un];Qe.update(Ka,hn),Qe.bind(Ka,hn)}}return hn}function Sr(w,G){w.ambientLightColor.needsUpdate=G,w.lightProbe.needsUpdate=G,w.sunLights.needsUpdate=G,w.sunLightShadows.needsUpdate=G,w.directionalLights.needsUpdate=G,w.directionalLightShadows.needsUpdate=G,w.pointLights.needsUpdate=G,w.pointLightShadows.needsUpdate=G,w.spotLights.needsUpdate=G,w.spotLightShadows.needsUpdate=G,w.rectAreaLights.needsUpdate=G,w.hemisphereLights.needsUpdate=G}function Rs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(w,G,ne){let $=Te.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Te.get(w.texture).__webglTexture=G,Te.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:ne,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,G){let ne=Te.get(w);ne.__webglFramebuffer=G,ne.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(w,G=0,ne=0){ce=w,q=G,V=ne;let $=null,Z=!1,De=!1;if(w){let Ne=Te.get(w);if(Ne.__useDefaultFramebuffer!==void 0){ye.bindFramebuffer(P.FRAMEBUFFER,Ne.__webglFramebuffer),ie.copy(w.viewport),pe.copy(w.scissor),he=w.scissorTest,ye.viewport(ie),ye.scissor(pe),ye.setScissorTest(he),Y=-1;return}else if(Ne.__webglFramebuffer===void 0)Ge.setupRenderTarget(w);else if(Ne.__hasExternalTextures)Ge.rebindTextures(w,Te.get(w.texture).__webglTexture,Te.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let dt=w.depthTexture;if(Ne.__boundDepthTexture!==dt){if(dt!==null&&Te.has(dt)&&(w.width!==dt.image.width||w.height!==dt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ge.setupDepthRenderbuffer(w)}}let Be=w.texture;(Be.isData3DTexture||Be.isDataArrayTexture||Be.isCompressedArrayTexture)&&(De=!0);let Ke=Te.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ke[G])?$=Ke[G][ne]:$=Ke[G],Z=!0):w.samples>0&&Ge.useMultisampledRTT(w)===!1?$=Te.get(w).__webglMultisampledFramebuffer:Array.isArray(Ke)?$=Ke[ne]:$=Ke,ie.copy(w.viewport),pe.copy(w.scissor),he=w.scissorTest}else ie.copy(Je).multiplyScalar(Ee).floor(),pe.copy(ft).multiplyScalar(Ee).floor(),he=pt;if(ne!==0&&($=W),ye.bindFramebuffer(P.FRAMEBUFFER,$)&&ye.drawBuffers(w,$),ye.viewport(ie),ye.scissor(pe),ye.setScissorTest(he),Z){let Ne=Te.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_CUBE_MAP_POSITIVE_X+G,Ne.__webglTexture,ne)}else if(De){let Ne=G;for(let Be=0;Be<w.textures.length;Be++){let Ke=Te.get(w.textures[Be]);P.framebufferTextureLayer(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0+Be,Ke.__webglTexture,ne,Ne)}}else if(w!==null&&ne!==0){let Ne=Te.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,Ne.__webglTexture,ne)}Y=-1};function wr(w){let G=Te.get(w);return(G.__readFormat!==w.format||G.__readType!==w.type)&&(G.__readFormat=w.format,G.__readType=w.type,G.__formatReadable=Ue.textureFormatReadable(w.format),G.__typeReadable=Ue.textureTypeReadable(w.type)),G}this.readRenderTargetPixels=function(w,G,ne,$,Z,De,Oe,Ne=0){if(!(w&&w.isWebGLRenderTarget)){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Be=Te.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Oe!==void 0&&(Be=Be[Oe],Array.isArray(Be)&&(Be=Be[0])),Be){ye.bindFramebuffer(P.FRAMEBUFFER,Be);try{let Ke=w.textures[Ne],dt=Ke.format,vt=Ke.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Ne);let Ze=wr(Ke);if(Ze.__formatReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ze.__typeReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=w.width-$&&ne>=0&&ne<=w.height-Z&&P.readPixels(G,ne,$,Z,Ae.convert(dt),Ae.convert(vt),De)}finally{let Ke=ce!==null?Te.get(ce).__webglFramebuffer:null;ye.bindFramebuffer(P.FRAMEBUFFER,Ke)}}},this.readRenderTargetPixelsAsync=async function(w,G,ne,$,Z,De,Oe,Ne=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Be=Te.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Oe!==void 0&&(Be=Be[Oe],Array.isArray(Be)&&(Be=Be[0])),Be)if(G>=0&&G<=w.width-$&&ne>=0&&ne<=w.height-Z){ye.bindFramebuffer(P.FRAMEBUFFER,Be);let Ke=w.textures[Ne],dt=Ke.format,vt=Ke.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Ne);let Ze=wr(Ke);if(Ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let bt=P.createBuffer();P.bindBuffer(P.PIXEL_PACK_BUFFER,bt),P.bufferData(P.PIXEL_PACK_BUFFER,De.byteLength,P.STREAM_READ),P.readPixels(G,ne,$,Z,Ae.convert(dt),Ae.convert(vt),0),P.bindBuffer(P.PIXEL_PACK_BUFFER,null);let Qt=ce!==null?Te.get(ce).__webglFramebuffer:null;ye.bindFramebuffer(P.FRAMEBUFFER,Qt);let Ft=P.fenceSync(P.SYNC_GPU_COMMANDS_COMPLETE,0);return P.flush(),await qg(P,Ft,4),P.bindBuffer(P.PIXEL_PACK_BUFFER,bt),P.getBufferSubData(P.PIXEL_PACK_BUFFER,0,De),P.bindBuffer(P.PIXEL_PACK_BUFFER,null),P.deleteBuffer(bt),P.deleteSync(Ft),De}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,G=null,ne=0){let $=Math.pow(2,-ne),Z=Math.floor(w.image.width*$),De=Math.floor(w.image.height*$),Oe=G!==null?G.x:0,Ne=G!==null?G.y:0;Ge.setTexture2D(w,0),P.copyTexSubImage2D(P.TEXTURE_2D,ne,0,0,Oe,Ne,Z,De),ye.unbindTexture()},this.copyTextureToTexture=function(w,G,ne=null,$=null,Z=0,De=0){let Oe,Ne,Be,Ke,dt,vt,Ze,bt,Qt,Ft=w.isCompressedTexture?w.mipmaps[De]:w.image;if(ne!==null)Oe=ne.max.x-ne.min.x,Ne=ne.max.y-ne.min.y,Be=ne.isBox3?ne.max.z-ne.min.z:1,Ke=ne.min.x,dt=ne.min.y,vt=ne.isBox3?ne.min.z:0;else{let _t=Math.pow(2,-Z);Oe=Math.floor(Ft.width*_t),Ne=Math.floor(Ft.height*_t),w.isDataArrayTexture?Be=Ft.depth:w.isData3DTexture?Be=Math.floor(Ft.depth*_t):Be=1,Ke=0,dt=0,vt=0}$!==null?(Ze=$.x,bt=$.y,Qt=$.z):(Ze=0,bt=0,Qt=0);let Bt=Ae.convert(G.format),mn=Ae.convert(G.type),We;G.isData3DTexture?(Ge.setTexture3D(G,0),We=P.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Ge.setTexture2DArray(G,0),We=P.TEXTURE_2D_ARRAY):(Ge.setTexture2D(G,0),We=P.TEXTURE_2D),ye.activeTexture(P.TEXTURE0),ye.pixelStorei(P.UNPACK_FLIP_Y_WEBGL,G.flipY),ye.pixelStorei(P.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),ye.pixelStorei(P.UNPACK_ALIGNMENT,G.unpackAlignment);let cn=ye.getParameter(P.UNPACK_ROW_LENGTH),wt=ye.getParameter(P.UNPACK_IMAGE_HEIGHT),rs=ye.getParameter(P.UNPACK_SKIP_PIXELS),hn=ye.getParameter(P.UNPACK_SKIP_ROWS),Tr=ye.getParameter(P.UNPACK_SKIP_IMAGES);ye.pixelStorei(P.UNPACK_ROW_LENGTH,Ft.width),ye.pixelStorei(P.UNPACK_IMAGE_HEIGHT,Ft.height),ye.pixelStorei(P.UNPACK_SKIP_PIXELS,Ke),ye.pixelStorei(P.UNPACK_SKIP_ROWS,dt),ye.pixelStorei(P.UNPACK_SKIP_IMAGES,vt);let Hi=w.isDataArrayTexture||w.isData3DTexture,os=G.isDataArrayTexture||G.isData3DTexture;if(w.isDepthTexture){let _t=Te.get(w),sn=Te.get(G),Fn=Te.get(_t.__renderTarget),kt=Te.get(sn.__renderTarget);ye.bindFramebuffer(P.READ_FRAMEBUFFER,Fn.__webglFramebuffer),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,kt.__webglFramebuffer);for(let un=0;un<Be;un++)Hi&&(P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Te.get(w).__webglTexture,Z,vt+un),P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Te.get(G).__webglTexture,De,Qt+un)),P.blitFramebuffer(Ke,dt,Ke+Oe,dt+Ne,Ze,bt,Ze+Oe,bt+Ne,P.DEPTH_BUFFER_BIT,P.NEAREST);ye.bindFramebuffer(P.READ_FRAMEBUFFER,null),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Te.has(w)){let _t=Te.get(w),sn=Te.get(G);ye.bindFramebuffer(P.READ_FRAMEBUFFER,L),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,H);for(let Fn=0;Fn<Be;Fn++)Hi?P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,_t.__webglTexture,Z,vt+Fn):P.framebufferTexture2D(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,_t.__webglTexture,Z),os?P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,sn.__webglTexture,De,Qt+Fn):P.framebufferTexture2D(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,sn.__webglTexture,De),Z!==0?P.blitFramebuffer(Ke,dt,Ke+Oe,dt+Ne,Ze,bt,Ze+Oe,bt+Ne,P.COLOR_BUFFER_BIT,P.NEAREST):os?P.copyTexSubImage3D(We,De,Ze,bt,Qt+Fn,Ke,dt,Oe,Ne):P.copyTexSubImage2D(We,De,Ze,bt,Ke,dt,Oe,Ne);ye.bindFramebuffer(P.READ_FRAMEBUFFER,null),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else os?w.isDataTexture||w.isData3DTexture?P.texSubImage3D(We,De,Ze,bt,Qt,Oe,Ne,Be,Bt,mn,Ft.data):G.isCompressedArrayTexture?P.compressedTexSubImage3D(We,De,Ze,bt,Qt,Oe,Ne,Be,Bt,Ft.data):P.texSubImage3D(We,De,Ze,bt,Qt,Oe,Ne,Be,Bt,mn,Ft):w.isDataTexture?P.texSubImage2D(P.TEXTURE_2D,De,Ze,bt,Oe,Ne,Bt,mn,Ft.data):w.isCompressedTexture?P.compressedTexSubImage2D(P.TEXTURE_2D,De,Ze,bt,Ft.width,Ft.height,Bt,Ft.data):P.texSubImage2D(P.TEXTURE_2D,De,Ze,bt,Oe,Ne,Bt,mn,Ft);ye.pixelStorei(P.UNPACK_ROW_LENGTH,cn),ye.pixelStorei(P.UNPACK_IMAGE_HEIGHT,wt),ye.pixelStorei(P.UNPACK_SKIP_PIXELS,rs),ye.pixelStorei(P.UNPACK_SKIP_ROWS,hn),ye.pixelStorei(P.UNPACK_SKIP_IMAGES,Tr),De===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&P.generateMipmap(We),ye.unbindTexture()},this.initRenderTarget=function(w){Te.get(w).__webglFramebuffer===void 0&&Ge.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Ge.setTextureCube(w,0):w.isData3DTexture?Ge.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Ge.setTexture2DArray(w,0):Ge.setTexture2D(w,0),ye.unbindTexture()},this.resetState=function(){q=0,V=0,ce=null,ye.reset(),Re.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=At._getDrawingBufferColorSpace(e),t.unpackColorSpace=At._getUnpackColorSpace()}};function I0(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let v=0;v<s;v++)r[3*v+0]=n.getX(v),r[3*v+1]=n.getY(v),r[3*v+2]=n.getZ(v)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let R=9*v,E=r[R+0],_=r[R+1],T=r[R+2],B=r[R+3],N=r[R+4],D=r[R+5],k=r[R+6],W=r[R+7],L=r[R+8],H=k-B,q=W-N,V=L-D,ce=E-B,Y=_-N,j=T-D,ie=q*j-V*Y,pe=V*ce-H*j,he=H*Y-q*ce,ee=1/(Math.sqrt(ie*ie+pe*pe+he*he)||1);c[3*v+0]=ie*ee,c[3*v+1]=pe*ee,c[3*v+2]=he*ee}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,g=new Int32Array(d),M=0;for(let v=0;v<s;v++){let R=3*v,E=Math.trunc(r[R+0]*a),_=Math.trunc(r[R+1]*a),T=Math.trunc(r[R+2]*a),B=(Math.imul(E,73856093)^Math.imul(_,19349663)^Math.imul(T,83492791))&f;for(;;){let N=g[B];if(N===0){let k=3*M;u[k+0]=E,u[k+1]=_,u[k+2]=T,g[B]=M+1,h[v]=M++;break}let D=3*(N-1);if(u[D+0]===E&&u[D+1]===_&&u[D+2]===T){h[v]=N-1;break}B=B+1&f}}let m=new Int32Array(M+1);for(let v=0;v<s;v++)m[h[v]+1]++;for(let v=0;v<M;v++)m[v+1]+=m[v];let p=new Int32Array(s),b=m.slice(0,M);for(let v=0;v<l;v++){let R=3*v;p[b[h[R+0]]++]=v,p[b[h[R+1]]++]=v,p[b[h[R+2]]++]=v}let C=new Float32Array(s*3);for(let v=0;v<l;v++){let R=3*v,E=c[R+0],_=c[R+1],T=c[R+2];for(let B=0;B<3;B++){let N=R+B,D=h[N],k=0,W=0,L=0;for(let q=m[D],V=m[D+1];q<V;q++){let ce=3*p[q],Y=c[ce+0],j=c[ce+1],ie=c[ce+2];E*Y+_*j+T*ie>o&&(k+=Y,W+=j,L+=ie)}let H=1/(Math.sqrt(k*k+W*W+L*L)||1);C[3*N+0]=k*H,C[3*N+1]=W*H,C[3*N+2]=L*H}}return t.setAttribute("normal",new Cn(C,3,!1)),t}var bT=Math.PI/6;async function L0(i){let e=new DataView((await Ml(i.data)).buffer),t=new Float32Array(3*i.points);for(let r=0;r<t.length;++r)t[r]=i.low[r%3]+i.step[r%3]*e.getUint16(2*r,!0);let n=new Uint16Array(3*i.triangles);for(let r=0;r<n.length;++r)n[r]=e.getUint16(2*(t.length+r),!0);let s=new en;return s.setAttribute("position",new Cn(t,3)),s.setIndex(new Cn(n,1)),I0(s,bT)}var D0=new Map;function wh(i,e){let t=D0.get(i)??e();return D0.set(i,t),t}function ws(i,e=1){return wh(`cylinder ${e} ${i}`,()=>new va(e,1,1,i).rotateX(Math.PI/2).translate(0,0,.5))}function rf(i){return wh(`ball ${i}`,()=>new ba(1,i,Math.round(.625*i)))}function N0(i){return wh(`quarters ${i}`,()=>{let e=rf(i).toNonIndexed(),t=e.getAttribute("position"),n=[];for(let s=0;s<t.count;s+=3){let r=1;for(let o of[0,1,2])r*=Math.sign([0,1,2].reduce((a,l)=>a+t.getComponent(s+l,o),0));for(let o=0;o<9;++o)n.push(r<0?1:.72)}return e.setAttribute("color",new zt(n,3)),e})}function of(i,e,t){return wh(`ring ${i} ${e} ${t}`,()=>new pr(1,i,e,t))}var nf=9,sf=16,di=6,Ha=.08;function U0(){let i=nf*sf+5,e=[];for(let n=0;n+1<i;++n)if(!(n===1||n===i-3))for(let s=0;s<di;++s){let[r,o]=[n*di+s,n*di+(s+1)%di];e.push(r,r+di,o,o,r+di,o+di)}let t=new en;t.setIndex(e);for(let n of["position","normal"])t.setAttribute(n,new zt(new Float32Array(3*i*di),3));return t}function O0(i,e,t,n){let s=nf*sf,r=i.getAttribute("position"),o=i.getAttribute("normal"),a=(1-2*Ha)*e,l=a/(2*Math.PI*nf*t),c=Math.hypot(1,l),h=(g,M,m,p)=>{for(let b=0;b<di;++b){let[C,v]=[Math.cos(2*Math.PI*b/di),Math.sin(2*Math.PI*b/di)],[R,E,_]=[C*m.x+v*p.x,C*m.y+v*p.y,C*m.z+v*p.z];o.setXYZ(g*di+b,R,E,_),r.setXYZ(g*di+b,M.x+n*R,M.y+n*E,M.z+n*_)}},[u,d,f]=[new F,new F,new F];for(let g=0;g<=s;++g){let M=2*Math.PI*g/sf;d.set(Math.sin(M),-Math.cos(M),0),f.set(-l*Math.cos(M)/c,-l*Math.sin(M)/c,1/c),u.copy(d).multiplyScalar(t).setZ(Ha*e+a*g/s),h(g+2,u,d,f)}f.set(-1,0,0);for(let[g,M]of[[0,-1],[s+3,1]]){let[m,p]=M<0?[0,Ha*e]:[(1-Ha)*e,e];d.set(0,-Ha*e,M*t).normalize(),h(g,u.set(0,M<0?0:-t,m),d,f),h(g+1,u.set(0,M<0?-t:0,p),d,f)}r.needsUpdate=o.needsUpdate=!0,i.computeBoundingBox(),i.computeBoundingSphere()}var tf=new F,Va=new F;function bi(i,e,t,n=t){let s=new F().subVectors(e,i),r=s.length(),o=r>0?s.clone().divideScalar(r):new F(0,0,1);return Va.set(0,1,0),Math.abs(o.y)>.9&&Va.set(1,0,0),tf.crossVectors(Va,o).normalize(),Va.crossVectors(o,tf),new gt().makeBasis(tf.clone().multiplyScalar(t),Va.clone().multiplyScalar(n),o.multiplyScalar(Math.max(r,1e-12))).setPosition(i)}function F0(i){let e=[[i[0],i[3],i[4]],[i[3],i[1],i[5]],[i[4],i[5],i[2]]],t=[[1,0,0],[0,1,0],[0,0,1]];for(let n=0;n<20;++n)for(let[s,r]of[[0,1],[0,2],[1,2]]){if(Math.abs(e[s][r])<1e-300)continue;let o=(e[r][r]-e[s][s])/(2*e[s][r]),a=Math.sign(o||1)/(Math.abs(o)+Math.sqrt(o*o+1)),l=1/Math.sqrt(a*a+1),c=a*l;for(let h=0;h<3;++h)[e[h][s],e[h][r]]=[l*e[h][s]-c*e[h][r],c*e[h][s]+l*e[h][r]];for(let h=0;h<3;++h)[e[s][h],e[r][h]]=[l*e[s][h]-c*e[r][h],c*e[s][h]+l*e[r][h]],[t[h][s],t[h][r]]=[l*t[h][s]-c*t[h][r],c*t[h][s]+l*t[h][r]]}return{values:[e[0][0],e[1][1],e[2][2]],axes:[0,1,2].map(n=>[t[0][n],t[1][n],t[2][n]])}}function B0([i,e,t,n,s,r],o){let a=Math.max(...[i,e,n,s,r].map(Math.abs)),l=Math.hypot(o.x,o.y);if(!(a<=1e-9*t&&t>0&&l>0&&Math.abs(o.z)<=1e-9*l))return null;let[c,h]=[o.x/l,o.y/l];return[[c,h,0],[-h,c,0],[0,0,1]]}function Mi(i,e){return Math.max(6,Math.round(e*i.detail))}var MT=.55,ST={rod:6583435,rope:6583435,spring:889992,damper:8141549,mass:2450411,body:3900150,box:3900150,cylinder:6333946,cone:3900150,disc:3900150,sphere:2450411,circle:4674921,mesh:9741240,arrow:14251782,force:14427686,torque:15357964,trace:14251782,slider:2450411,dial:2450411,ground:9741240,velocity:1483594,acceleration:9647082,admissible:14362487,reaction:165063,"reaction torque":947344,constraint:11817737,friction:12592851};function lf(i){let e=i.texts.color;return e!==void 0&&CSS.supports("color",e)?e:ST[i.kind]??6583435}function pi(i,e){let t=new Ni({color:lf(i)}),n=new tn(e,t);return n.matrixAutoUpdate=!1,n}function yt(i,e,t){let n=t.first+i.numbers[e];return new F(t.numbers[n],t.numbers[n+1],t.numbers[n+2])}function fi(i,e,t,n){let s=i.numbers[e];return s===void 0?n:t.numbers[t.first+s]}function hf(i,e){return"x"in i.numbers?[yt(i,"x",e),yt(i,"y",e),yt(i,"z",e)]:[new F(1,0,0),new F(0,1,0),new F(0,0,1)]}function Wa(i,e,t,n,s){let[r,o,a]=hf(i,e);return new gt().makeBasis(r.multiplyScalar(t),o.multiplyScalar(n),a.multiplyScalar(s)).setPosition(yt(i,"at",e))}function wT(i,e){let[t,n,s]=hf(i,e);if(!i.vectors.includes("axis"))return s;let r=yt(i,"axis",e),o=t.multiplyScalar(r.x).addScaledVector(n,r.y).addScaledVector(s,r.z);return o.lengthSq()>0?o.normalize():new F(0,0,1)}function k0(i,e,t,n){let s=pi(i,t);return{object:s,shape:i,update(r){let o=fi(i,"radius",r,n*e.length);s.matrix.copy(bi(yt(i,"at",r),yt(i,"to",r),o))}}}function TT(i,e){let t=U0(),n=pi(i,t);n.userData.bent=!0;let[s,r]=[0,0];return{object:n,shape:i,update(o){let[a,l]=[yt(i,"at",o),yt(i,"to",o)],c=fi(i,"radius",o,.03*e.length),h=a.distanceTo(l);(h!==s||c!==r)&&O0(t,h,c,.16*c),[s,r]=[h,c],n.matrix.copy(bi(a,l,1)).scale(new F(1,1,1/Math.max(h,1e-12)))}}}function AT(i,e){let t=new In,n=pi(i,ws(Mi(e,24))),s=pi(i,ws(Mi(e,24)));return t.add(n,s),{object:t,shape:i,update(r){let[o,a]=[yt(i,"at",r),yt(i,"to",r)];n.matrix.copy(bi(o,a,.005*e.length)),s.matrix.copy(bi(o.clone().lerp(a,.2),o.clone().lerp(a,.6),.016*e.length))}}}function z0(i,e){let t=pi(i,rf(Mi(e,32)));return{object:t,shape:i,update(n){let s=fi(i,"mass",n,e.mass),r=e.mass>0?Math.cbrt(Math.max(s,0)/e.mass):1,o=fi(i,"radius",n,.04*e.length*Math.max(r,.25));t.matrix.copy(Wa(i,n,o,o,o))}}}function ET(i,e){let t=pi(i,N0(Mi(e,32)));return Object.assign(t.material,{transparent:!0,opacity:MT,depthWrite:!1,vertexColors:!0}),{object:t,shape:i,update(n){let s=fi(i,"mass",n,1),r=n.first+i.numbers.inertia,{values:o,axes:a}=F0(Array.from(n.numbers.subarray(r,r+6))),l=o[0]+o[1]+o[2],c=.012*e.length,h=o.map(v=>{let R=2.5*(l-2*v)/s;return s>0&&R>0?Math.min(Math.max(Math.sqrt(R),c),e.length):c}),[u,d,f]=hf(i,n),g=v=>new F().addScaledVector(u,v[0]).addScaledVector(d,v[1]).addScaledVector(f,v[2]),M=yt(i,"com",n),m=B0(Array.from(n.numbers.subarray(r,r+6)),M),p=Math.min(Math.sqrt(3*l/s),e.length),b=m?m.map((v,R)=>g(v).multiplyScalar(R===0?p:c)):a.map((v,R)=>g(v).multiplyScalar(h[R])),C=yt(i,"at",n).add(g([M.x,M.y,M.z]));t.matrix.makeBasis(b[0],b[1],b[2]).setPosition(C)}}}function CT(i,e){let t=pi(i,new Jn(1,1,1)),n=.09*e.length;return{object:t,shape:i,update(s){let r=fi(i,"width",s,n),o=fi(i,"height",s,n),[a,l]=e.planar?[o,r]:[r,o];if("to"in i.numbers){let[c,h]=[yt(i,"at",s),yt(i,"to",s)];t.matrix.copy(bi(c,h,a,l)).multiply(new gt().makeTranslation(0,0,.5))}else if(i.vectors.includes("size")){let c=yt(i,"size",s);t.matrix.copy(Wa(i,s,c.x,c.y,c.z))}else{let c=fi(i,"length",s,n);t.matrix.copy(Wa(i,s,c,a,l))}}}}function cf(i,e,t){return(n,s)=>{let r=pi(n,ws(Mi(s,40),t));return{object:r,shape:n,update(o){let a=fi(n,"radius",o,i*s.length),l=yt(n,"at",o);if("to"in n.numbers){r.matrix.copy(bi(l,yt(n,"to",o),a));return}let c=wT(n,o),h=fi(n,"length",o,fi(n,"height",o,e*a)),u=t===1,d=u?l.clone().addScaledVector(c,-h/2):l.clone().addScaledVector(c,h),f=u?l.clone().addScaledVector(c,h/2):l;r.matrix.copy(bi(d,f,a)),"x"in n.numbers&&RT(r.matrix,yt(n,"x",o),a)}}}}function RT(i,e,t){let n=new F().setFromMatrixColumn(i,2),s=new F().setFromMatrixPosition(i),r=n.clone().normalize(),o=e.clone().addScaledVector(r,-e.dot(r));if(o.lengthSq()<1e-12)return;o.normalize();let a=new F().crossVectors(r,o);i.makeBasis(o.multiplyScalar(t),a.multiplyScalar(t),n).setPosition(s)}function PT(i,e){let t=cf(.1,.12,1)(i,e),n=new tn(new Jn(.9,.08,1.04).translate(.45,0,.5),new Ni({color:16317180}));return t.object.add(n),t}function IT(i,e){let t="radius"in i.numbers,n=pi(i,t?of(.02,Mi(e,12),64):of(.28,Mi(e,8),Mi(e,24)));return{object:n,shape:i,update(s){let r=fi(i,"radius",s,.014*e.length);n.matrix.copy(Wa(i,s,r,r,r))}}}function LT(i,e){let t=pi(i,e.meshes[i.mesh??-1]??new en);return t.material.side=Zn,{object:t,shape:i,update(n){let s=fi(i,"scale",n,1),{x:r,y:o,z:a}=i.vectors.includes("scale")?yt(i,"scale",n):new F(s,s,s);t.matrix.copy(Wa(i,n,r,o,a))}}}var G0=i=>(e,t,n)=>yt(e,"vector",t).multiplyScalar(n[i]),DT=(i,e,t)=>"vector"in i.numbers?yt(i,"vector",e).normalize().multiplyScalar(.2*t.length):yt(i,"to",e).sub(yt(i,"at",e));function af(i){return(e,t)=>{let n=new In,s=pi(e,ws(Mi(t,24))),r=pi(e,ws(Mi(t,24),.001));return n.add(s,r),{object:n,shape:e,update(o){let a=yt(e,"at",o),l=i(e,o,t),c=l.length();if(n.visible=c>1e-6*t.length,!n.visible)return;let h=Math.min(.05*t.length,.6*c),u=a.clone().addScaledVector(l,1-h/c);s.matrix.copy(bi(a,u,.006*t.length)),r.matrix.copy(bi(u,a.clone().add(l),.018*t.length))}}}}function NT(i,e){let t=new In,n=new ys(new en,new Hs({color:lf(i)})),s=new ys(n.geometry.clone(),new Hs({color:lf(i),transparent:!0,opacity:.25}));n.frustumCulled=s.frustumCulled=!1,t.add(n,s);let r=null;return{object:t,shape:i,update(){},follow(o,a){if(o!==r){r=o;let l=new Float32Array(3*o.count),c=e.first+i.numbers.at;for(let h=0;h<o.count;++h)for(let u=0;u<3;++u)l[3*h+u]=o.at(h,c+u);for(let h of[n,s])h.geometry.dispose(),h.geometry=new en,h.geometry.setAttribute("position",new Cn(l,3))}n.geometry.setDrawRange(0,a+1)}}}function uf(i,e,t){let n=document.createElement("canvas"),s=n.getContext("2d"),r="48px system-ui, sans-serif";if(s===null)return new Di;s.font=r,n.width=Math.ceil(s.measureText(i).width)+16,n.height=64,s.font=r,s.fillStyle=t,s.textBaseline="middle",s.fillText(i,8,34);let o=new Di(new vo({map:new _a(n),depthTest:!1}));return o.userData.words=i,o.scale.set(e*n.width/64,e,1),o}function UT(i,e){let t=uf(i.texts.text??i.name,.06*e.length,"#64748b");return{object:t,shape:i,update:n=>{t.position.copy(yt(i,"at",n))}}}function OT(i,e){let t=new In,n=(i.name==="world"?.12:.07)*e.length,r=[14427686,1483594,2450411].map(o=>{let a=new tn(ws(8),new Ni({color:o}));return a.matrixAutoUpdate=!1,t.add(a),a});return{object:t,shape:i,update(o){let a=yt(i,"at",o);["x","y","z"].forEach((l,c)=>{let h=a.clone().addScaledVector(yt(i,l,o),n);r[c].matrix.copy(bi(a,h,.03*n))})}}}function FT(i,e){let t=pi(i,new Jn(1,1,1).translate(0,0,-.5)),n=null;return{object:t,shape:i,update(){},follow(s){if(s===n)return;n=s;let r={numbers:Float64Array.from({length:s.width},(u,d)=>s.at(0,d)),first:e.first},o=yt(i,"normal",r),a=yt(i,"at",r),l=e.center.clone().addScaledVector(o,o.dot(a.sub(e.center))),c=l.clone().addScaledVector(o,-1),h=1.3*e.length;t.matrix.copy(bi(c,l,h,h)).multiply(new gt().makeTranslation(0,0,1)),t.matrix.multiply(new gt().makeScale(1,1,.02*e.length))}}}var Th={rod:(i,e)=>k0(i,e,ws(Mi(e,24)),.007),rope:(i,e)=>k0(i,e,ws(Mi(e,24)),.004),spring:TT,damper:AT,box:CT,cylinder:cf(.03,2.4,1),cone:cf(.06,2,.001),disc:PT,sphere:z0,mass:z0,body:ET,circle:IT,mesh:LT,arrow:af(DT),force:af(G0("force")),torque:af(G0("torque")),trace:NT,text:UT,frame:OT,ground:FT};var q0=[["velocity","v","Velocities of masses"],["acceleration","a","Accelerations of masses"],["admissible","\u2202r/\u2202q","Admissible motions of masses: each coordinate alone"],["reaction","reactions","Forces and torques of joints, rods and wires"],["constraint","constraints","Forces of constraints on masses"],["friction","friction","Dry friction: its forces, and whether it sticks or slides"]],BT={velocity:"m/s",acceleration:"m/s\xB2",reaction:"N","reaction torque":"N\xB7m",constraint:"N",friction:"N",force:"N",torque:"N\xB7m"},H0=["#db2777","#7c3aed","#0891b2","#65a30d","#ca8a04","#dc2626","#2563eb","#0d9488"],V0=.3,df=8,W0=1e-10,kT=["open","slides","sticks"],Ah=class{constructor(e,t,n){this.vectors=e;this.sizes=t;let s=e.shapes.flatMap(r=>r.texts.coordinate??[]);this.coordinates=[...new Set(s)];for(let r of e.shapes.filter(X0)){let o=this.coordinates.indexOf(r.texts.coordinate??"");o>=0&&(r.texts.color=H0[o%H0.length]);let a=this.scales.get(Xa(r))??{...t,first:e.first};this.scales.set(Xa(r),a);let l=Th.force(r,a);l.object.traverse(c=>c.userData.shape=r),l.object.visible=!1,this.drawn.push(l),n.add(l.object)}}vectors;sizes;drawn=[];shown=new Set;coordinates;coordinate="";scales=new Map;motion=null;row=0;largest=0;numbers=new Float64Array(0);has(e){return this.vectors.shapes.some(t=>ff(t)===e)}take(e){this.motion=e,this.numbers=new Float64Array(e.width);let t=new Map;for(let n of this.vectors.shapes.filter(X0)){let s=this.vectors.first+n.numbers.vector;for(let r=0;r<e.count;++r){let o=Math.hypot(e.at(r,s),e.at(r,s+1),e.at(r,s+2));Number.isFinite(o)&&t.set(Xa(n),Math.max(t.get(Xa(n))??0,o))}}this.largest=0;for(let n of this.vectors.shapes.filter(({kind:s})=>s==="friction")){let s=this.vectors.first+n.numbers.value;this.largest=Math.max(this.largest,e.largest(s),n.texts.components==="2"?e.largest(s+1):0)}for(let[n,s]of this.scales){let r=t.get(n)??0,o=n.startsWith("reaction torque")?this.sizes.length*(t.get("reaction N")??0):0;s.force=r>W0*o?V0*this.sizes.length/r:0}}pose(e){if(this.motion!==null&&this.motion.count>0){let n=Math.min(e,this.motion.last);this.motion.state(n,this.numbers),this.row=this.motion.rowAt(n)}let t={numbers:this.numbers,first:this.vectors.first};for(let n of this.drawn){let s=this.coordinate===""||(n.shape.texts.coordinate??this.coordinate)===this.coordinate;this.shown.has(ff(n.shape))&&s&&this.motion!==null?n.update(t):n.object.visible=!1,n.object.updateMatrixWorld(!0)}}value(e){if(e.kind==="friction")return this.rubs(e);let t=yt(e,"vector",{numbers:this.numbers,first:this.vectors.first});return`${qa(t.length())} ${Ts(e)}`}legend(){let e=[],t=[];for(let[o,a]of this.scales){let l=this.vectors.shapes.find(u=>Xa(u)===o);if(l===void 0||!this.shown.has(ff(l))||a.force===0)continue;let c=Ts(l)==="1"?"":` ${Ts(l)}`,h=`${qa(V0*this.sizes.length/a.force)}${c}`;l.kind==="admissible"?t.push(...this.movedIn(Ts(l)).map(u=>`\u2202r/\u2202${ym(u)}: ${h}`)):e.push(`${l.kind}: longest ${h}`)}if(t.length>0&&e.unshift(`longest ${t.join(", ")}`),!this.shown.has("friction")||this.motion===null)return e;let s=[...new Map(this.vectors.shapes.filter(({kind:o})=>o==="friction").map(o=>[o.name,o])).values()].map(o=>`${o.name}: ${this.rubs(o)}`),r=s.length>df?[`and ${s.length-df} more`]:[];return[...e,...s.slice(0,df),...r]}movedIn(e){let t=this.vectors.shapes.filter(s=>s.kind==="admissible"&&Ts(s)===e);return[...new Set(t.flatMap(s=>s.texts.coordinate??[]))].filter(s=>this.coordinate===""||s===this.coordinate)}rubs(e){let{first:t}=this.vectors,n=kT[this.motion?.at(this.row,t+e.numbers.mode)??0]??"";if(n==="open")return n;let s=t+e.numbers.value,r=Math.hypot(...this.numbers.subarray(s,s+Number(e.texts.components)));return`${n}, ${qa(r>W0*this.largest?r:0)} ${Ts(e)}`}};function X0(i){return"vector"in i.numbers}function Ts(i){return i.texts.unit??BT[i.kind]??""}function qa(i){return Number(i.toPrecision(3)).toString()}function ff(i){return i.kind==="reaction torque"?"reaction":i.kind}function Xa(i){return`${i.kind} ${Ts(i)}`}var zT=[.1,.25,.5,1,2,4],GT=[1,60],HT=5;function VT(i){let[e,t]=GT;return i>=e&&i<=t?1:Number(Vr(i/HT).toPrecision(1))}var Eh=class{constructor(e,t,n){this.moved=n;this.time=e.start,this.span=[e.start,e.stop],this.again=e.modes!==void 0,this.speed=this.again?1:VT(e.stop-e.start);let s=this.speed===1?zT:[...[.1,.2,.5,1,2,5].map(l=>l*this.speed),1];this.choices=[...new Set(s.map(l=>Number(l.toPrecision(3))))].sort((l,c)=>l-c),this.button=et("button",{className:"play",onclick:()=>this.toggle()});let{start:r,stop:o}=e;this.bar=et("input",{type:"range",min:`${r}`,max:`${o}`,step:"any",value:`${r}`,ariaLabel:"Time"}),this.bar.oninput=()=>this.go(Number(this.bar.value)),this.clock=et("output",{className:"clock"}),this.ticks=et("div",{className:"ticks",ariaHidden:"true"});let a=et("div",{className:"track"},this.ticks,this.bar);this.chooser=this.speeds(),t.append(this.button,a,this.clock,this.chooser),this.mark(e.events),this.show()}moved;time;speed;choices;pace=1;span;again;running=!1;before=0;bar;button;clock;ticks;chooser;over(e,t,n){let[s,r]=this.span,o=(this.time-s)/(r-s||1),a=s===e&&r===t;this.span=[e,t],this.pace=n,Object.assign(this.bar,{min:`${e}`,max:`${t}`}),a||(this.time=e+o*(t-e)),this.show()}faster(e){let t=Math.min(Math.max(this.choices.indexOf(this.speed)+e,0),this.choices.length-1);this.speed=this.choices[t],this.chooser.value=`${this.speed}`}speeds(){let e=et("select",{ariaLabel:"Speed"});for(let t of this.choices)e.append(new Option(`${t}\xD7`,`${t}`,t===this.speed,t===this.speed));return e.onchange=()=>this.speed=Number(e.value),e}mark(e){let[t,n]=this.span,s=ml(e,t,n).map(({time:o,name:a,kind:l})=>{let c=et("i",{title:`${a} ${l}`,className:l});return c.style.left=`${100*(o-t)/(n-t)}%`,c}),r=gl(e,t,n).map(o=>et("b",{style:`opacity: ${.5*o}`}));this.ticks.replaceChildren(...r,...s)}toggle(){this.running?this.pause():this.play()}play(){this.time>=this.span[1]&&([this.time]=this.span),this.running=!0,this.before=performance.now(),requestAnimationFrame(e=>this.tick(e)),this.show()}pause(){this.running=!1,this.show()}go(e){this.time=Math.min(Math.max(e,this.span[0]),this.span[1]),this.show(),this.moved(this.time)}step(e){this.pause(),this.go(this.time+e*(this.span[1]-this.span[0]))}get digits(){return Math.min(Math.max(2-Math.floor(Math.log10((this.span[1]-this.span[0])/2)),2),9)}tick(e){if(!this.running)return;let t=this.time+(e-this.before)/1e3*this.speed*this.pace;if(this.before=e,t>=this.span[1]&&!this.again){this.go(this.span[1]),this.pause();return}this.go(t>=this.span[1]?this.span[0]:t),requestAnimationFrame(n=>this.tick(n))}show(){this.button.textContent=this.running?"\u275A\u275A":"\u25B6",this.button.setAttribute("aria-label",this.running?"Pause":"Play"),this.bar.value=`${this.time}`,this.clock.value=`${this.time.toFixed(this.digits)} s`}};var As={left:62,right:10,top:8,bottom:34},WT="http://www.w3.org/2000/svg";function $0(i){let e=document.createElement("div");e.className="locus";let t=i.unit&&i.unit!=="1"?` [${i.unit}]`:"",[n,s]=[Math.min(...i.values),Math.max(...i.values)],r=(l,c)=>i.values.flatMap((h,u)=>i.eigenvalues[u].flatMap(d=>d===null?[]:[{x:l(h,d),y:c(d),part:(h-n)/(s-n||1),words:`${i.name} = ${h.toPrecision(4)}`}])),o=i.thresholds.map(l=>l.value);e.append(pf(r((l,c)=>c[0],l=>l[1]),"real part [1/s]","imaginary part [1/s]",[],!0),pf(r(l=>l,l=>l[0]),`${i.name}${t}`,"real part [1/s]",o,!1),pf(r(l=>l,l=>Math.abs(l[1])/(2*Math.PI)),`${i.name}${t}`,"frequency [Hz]",o,!1));let a=document.createElement("ul");for(let{value:l,kind:c,frequency:h,unstable_above:u}of i.thresholds){let d=document.createElement("li"),f=h>0?` at ${h.toPrecision(4)} Hz`:"";d.textContent=`${c}${f} ${u?"above":"below"} ${i.name} = ${l.toPrecision(6)} ${i.unit}`,a.append(d)}return i.thresholds.length>0&&e.append(a),e}function br(i,e,t=""){let n=document.createElementNS(WT,i);for(let[s,r]of Object.entries(e))n.setAttribute(s,`${r}`);return t!==""&&(n.textContent=t),n}function Y0(i){let[e,t]=[Math.min(...i),Math.max(...i)],n=t>e?.06*(t-e):1;return[e-n,t+n]}function pf(i,e,t,n,s){let r=br("svg",{viewBox:"0 0 420 200",role:"img","aria-label":`${t} over ${e}`}),[o,a]=Y0([...i.map(g=>g.x),...s?[0]:[]]),[l,c]=Y0([...i.map(g=>g.y),0]),h=g=>As.left+(g-o)/(a-o)*(420-As.left-As.right),u=g=>200-As.bottom-(g-l)/(c-l)*(200-As.top-As.bottom),d=(g,M,m)=>{r.append(br("line",{x1:g[0],y1:g[1],x2:M[0],y2:M[1],class:m}))};d([h(o),u(0)],[h(a),u(0)],"axis"),s&&d([h(0),u(l)],[h(0),u(c)],"axis");for(let g of n)d([h(g),u(l)],[h(g),u(c)],"threshold");for(let g of i){let M=br("circle",{cx:h(g.x).toFixed(2),cy:u(g.y).toFixed(2),r:2,fill:`hsl(${(230-190*g.part).toFixed(0)} 70% 50%)`});M.append(br("title",{},g.words)),r.append(M)}let f=[[h(o),180,"start",o.toPrecision(3)],[h(a),180,"end",a.toPrecision(3)],[As.left-4,u(l),"end",l.toPrecision(3)],[As.left-4,u(c)+9,"end",c.toPrecision(3)]];for(let[g,M,m,p]of f)r.append(br("text",{x:g,y:M,"text-anchor":m},p));return r.append(br("text",{x:(As.left+420)/2,y:194,"text-anchor":"middle"},e)),r.append(br("text",{x:-200/2+10,y:12,"text-anchor":"middle",transform:"rotate(-90)"},t)),r}var Ch=class{constructor(e,t,n){this.head=e;this.chosen=n;let s=et("section",{id:"runs"});e.modes!==void 0?this.modes(s,e.modes):e.runs!==void 0&&e.runs.length>1&&this.sweep(s,e.runs.map(r=>r.label)),t.prepend(s)}head;chosen;level=0;mode=0;buttons=[];sweep(e,t){let n=et("input",{type:"range",min:"0",max:`${t.length-1}`,step:"1",value:"0",ariaLabel:"Run"}),s=et("output"),r=()=>{let o=Number(n.value);s.textContent=`Run ${o+1} of ${t.length}: ${t[o]}`,n.ariaValueText=s.textContent};n.oninput=()=>{r(),this.chosen(Number(n.value))},r(),e.append(et("label",{},s,n))}modes(e,t){let n=this.head.levels??[""];this.level=Math.min(1,n.length-1);let s=et("p",{textContent:this.head.stability??""}),r=et("div",{className:"modes"});t.forEach((l,c)=>{let h=et("button",{textContent:`${c+1}: ${XT(l)}`});h.onclick=()=>{this.mode=c,this.show(t,a)},this.buttons.push(h),r.append(h)});let o=et("select",{ariaLabel:"Amplitude"});n.forEach((l,c)=>o.append(new Option(`amplitude: ${l}`,`${c}`,c===this.level,c===this.level))),o.onchange=()=>{this.level=Number(o.value),this.show(t,a)};let a=et("table",{className:"shape"});e.append(s,r,o,a),this.head.locus!=null&&e.append($0(this.head.locus)),this.show(t,a)}get run(){return this.mode*(this.head.levels?.length??1)+this.level}show(e,t){this.buttons.forEach((r,o)=>r.ariaPressed=`${o===this.mode}`);let n=et("tr",{},...["shape","size","phase"].map(r=>et("th",{scope:"col",textContent:r}))),s=e[this.mode].shape.map(({name:r,size:o,phase:a})=>{let l=[r,o.toPrecision(3),o>1e-9?`${a.toFixed(0)}\xB0`:""];return et("tr",{},...l.map(c=>et("td",{textContent:c})))});t.replaceChildren(n,...s),this.chosen(this.run)}};function XT(i){let[e]=i.eigenvalue,t=i.frequency>0?[`${i.frequency.toPrecision(4)} Hz`]:[`${e.toPrecision(4)} 1/s`];return i.frequency>0&&i.damping!==null&&Math.abs(i.damping)>1e-7&&t.push(`damping ${i.damping.toPrecision(3)}`),i.constant!==null&&t.push(`${i.constant>0?"falls":"grows"} in ${Math.abs(i.constant).toPrecision(3)} s`),t.join(", ")}var qT=1e-12,YT=12;function $T(i){return i.group==="parameter"||i.kind!=="Real"}function Z0({minimum:i,maximum:e,display:t},n){let s=r=>Math.abs(n-r)<=qT*(Math.abs(r)+Math.abs(t.shift/t.scale));return[i,e].find(r=>r!==null&&s(r))??n}function ZT(i,e){let{minimum:t,maximum:n}=i;if(Number.isNaN(e))return"this is no number";let s=Rh(i,e);return Number.isFinite(e)?i.kind!=="Real"&&!Number.isSafeInteger(e)?`${s} is no whole number below 2^53`:t!==null&&e<t?`${s} is below min = ${Rh(i,t)}`:n!==null&&e>n?`${s} is above max = ${Rh(i,n)}`:"":`${s} is not finite`}function mf(i,e,t){let n=ZT(i,e),s=Number.isFinite(e)&&(n===""||!$T(i));return n===""?{taken:s,words:n}:{taken:s,words:s?`${n}; the run takes it`:`${n}; the value stays ${Rh(i,t)}`}}function Rh({display:i},e){return`${$i(e*i.scale+i.shift,YT)} ${i.unit}`.trim()}var JT=[["start","More start values"],["parameter","More parameters"],["input","More inputs"]],gf=1e3;function KT(i,e){let{minimum:t,maximum:n,display:s}=i,r=Math.min(Math.max(i.value,t??-1/0),n??1/0),[o,a]=r===0?[-1,1]:[r/Math.sqrt(10),r*Math.sqrt(10)];if(i.angle)[o,a]=[Math.min(-Math.PI,r),Math.max(Math.PI,r)];else if(i.group!=="parameter"){let l=Vr((Math.max(2*Math.abs(r),e)||1)*s.scale)/s.scale;[o,a]=[-l,l]}return o>a&&([o,a]=[a,o]),[t??o,n??a]}function _f(i,e){return $i(e*i.display.scale+i.display.shift,4)}function jT(i){return i.split(/(?<=[._])|(?=\[)/).flatMap(e=>[e,et("wbr")])}var Ph=class{constructor(e,t,n,s){this.head=e;this.motion=t;this.place=n;this.changed=s;this.values=new Map([...e.parameters,...e.inputs].map(a=>[a,a.value]));let r=e.sliders.flatMap(a=>[...this.values.keys()].filter(l=>l.name===a));n.append(...r.map(a=>this.row(a)));for(let[a,l]of JT){let c=[...this.values.keys()].filter(u=>u.group===a&&!r.includes(u));if(c.length===0)continue;let h=r.length===0;n.append(et("details",{open:h},et("summary",{textContent:l}),...c.map(u=>this.row(u))))}let o=()=>{for(let a of this.values.keys())this.values.set(a,a.value);this.reread(),s()};n.append(et("button",{textContent:"Reset all",onclick:o}))}head;motion;place;changed;values;put(e,t){let n=[...this.values.keys()].find(s=>s.name===e);n!==void 0&&this.values.set(n,t),this.reread()}set(e,t){let n=this.head.parameters.find(s=>s.name===e);n!==void 0&&(this.put(e,t(this.values.get(n)??n.value)),this.changed())}reread(){this.place.querySelectorAll("input").forEach(e=>e.dispatchEvent(new Event("reread")))}get parameters(){return Float64Array.from(this.head.parameters,e=>this.values.get(e)??e.value)}get inputs(){return Float64Array.from(this.head.inputs,e=>this.values.get(e)??e.value)}take(e){this.head.parameters.forEach((t,n)=>this.values.set(t,e[n])),this.reread()}largest(e){let t=this.head.columns.find(o=>o.name===e),n=this.head.columns.map((o,a)=>t!==void 0&&o.kind===t.kind&&o.unit===t.unit?this.motion.largest(a):0),[s,r]=[t===void 0?0:n[this.head.columns.indexOf(t)],Math.max(...n)];return s>1e-9*r?s:r}row(e){let t=e.group==="start"?e.name.replace(/\.start$/,""):e.name,[n,s]=KT(e,e.group==="start"?this.largest(t):0),r=e.kind!=="Real",{unit:o}=e.display,a=et("input",{type:"range",min:"0",max:`${gf}`,step:r?"any":"1",ariaLabel:e.name}),l=et("input",{type:"number",step:"any",ariaLabel:`${e.name} in ${o||"SI units"}`}),c=et("span",{className:"fault",ariaLive:"polite"}),h=m=>{c.textContent=m,c.hidden=m==="",l.setAttribute("aria-invalid",`${m!==""}`)},u=()=>this.values.get(e)??e.value,d=()=>{let m=u();a.value=`${gf*(m-n)/(s-n||1)}`,l.value=_f(e,m),h(mf(e,m,m).words)},f=m=>{let p=Z0(e,m),{taken:b,words:C}=mf(e,p,u());b&&(this.values.set(e,p),this.changed()),d(),h(C)};a.oninput=()=>{let m=n+(s-n)*Number(a.value)/gf;f(r?Math.round(m):m)},l.onchange=()=>f((l.valueAsNumber-e.display.shift)/e.display.scale),a.addEventListener("reread",d);let g=et("span",{},...jT(t)),M=et("label",{title:e.doc??""},g,a,l,et("span",{className:"unit",textContent:o}),c);return M.ondblclick=()=>f(e.value),d(),M}};function QT(i,e){return i===""?["\u200B"]:[...e.slice(0,i.length).matchAll(/(.)\1*/gs)].map(({index:t,0:n,1:s})=>et("span",{className:`ink-${s}`,textContent:i.slice(t,t+n.length)}))}var Ih=class{lines;pinned=[];constructor(e,t,n,s){let r=0;this.lines=e.source.split(`
`).map((o,a)=>{let l=et("div",{className:"line"},...QT(o,e.inks.slice(r,r+=o.length+1)));l.dataset.number=`${a+1}`;let c={first:[a+1,1],last:[a+2,1]};return l.onpointerenter=()=>n(c),l.onpointerleave=()=>n(null),l.onclick=()=>s(c),l}),t.append(...this.lines)}pin(e){this.pinned=e,this.mark(e)}mark(e){this.lines.forEach((t,n)=>{t.classList.toggle("marked",[...e,...this.pinned].some(s=>n+1>=s.first[0]&&n+1<=s.last[0]))}),e.length>0&&this.lines[e[0].first[0]-1]?.scrollIntoView({block:"nearest"})}};var J0={type:"change"},yf={type:"start"},j0={type:"end"},Lh=new Gs,K0=new Wn,eA=Math.cos(70*xh.DEG2RAD),Mn=new F,jn=2*Math.PI,Lt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},xf=1e-6,Dh=class extends Ca{constructor(e,t=null){super(e,t),this.state=Lt.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qs.ROTATE,MIDDLE:qs.DOLLY,RIGHT:qs.PAN},this.touches={ONE:Ys.ROTATE,TWO:Ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new li,this._lastTargetPosition=new F,this._quat=new li().setFromUnitVectors(e.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new To,this._sphericalDelta=new To,this._scale=1,this._panOffset=new F,this._rotateStart=new Xe,this._rotateEnd=new Xe,this._rotateDelta=new Xe,this._panStart=new Xe,this._panEnd=new Xe,this._panDelta=new Xe,this._dollyStart=new Xe,this._dollyEnd=new Xe,this._dollyDelta=new Xe,this._dollyDirection=new F,this._mouse=new Xe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=nA.bind(this),this._onPointerDown=tA.bind(this),this._onPointerUp=iA.bind(this),this._onContextMenu=hA.bind(this),this._onMouseWheel=oA.bind(this),this._onKeyDown=aA.bind(this),this._onTouchStart=lA.bind(this),this._onTouchMove=cA.bind(this),this._onMouseDown=sA.bind(this),this._onMouseMove=rA.bind(this),this._interceptControlDown=uA.bind(this),this._interceptControlUp=dA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Lt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(J0),this.update(),this.state=Lt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Lt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=jn:n>Math.PI&&(n-=jn),s<-Math.PI?s+=jn:s>Math.PI&&(s-=jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Lh.origin.copy(this.object.position),Lh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Lh.direction))<eA?this.object.lookAt(this.target):(K0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Lh.intersectPlane(K0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>xf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>xf||this._lastTargetPosition.distanceToSquared(this.target)>xf?(this.dispatchEvent(J0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?jn/60*this.autoRotateSpeed*e:jn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/t.clientHeight),this._rotateUp(jn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/t.clientHeight),this._rotateUp(jn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Xe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function tA(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function nA(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function iA(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(j0),this.state=Lt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function sA(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Lt.DOLLY;break;case qs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Lt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Lt.ROTATE}break;case qs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Lt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Lt.PAN}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(yf)}function rA(i){switch(this.state){case Lt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Lt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Lt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function oA(i){this.enabled===!1||this.enableZoom===!1||this.state!==Lt.NONE||(i.preventDefault(),this.dispatchEvent(yf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(j0))}function aA(i){this.enabled!==!1&&this._handleKeyDown(i)}function lA(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ys.ROTATE:if(this.enableRotate===!1){this.state=Lt.NONE;break}this._handleTouchStartRotate(i),this.state=Lt.TOUCH_ROTATE;break;case Ys.PAN:if(this.enablePan===!1){this.state=Lt.NONE;break}this._handleTouchStartPan(i),this.state=Lt.TOUCH_PAN;break;default:this.state=Lt.NONE}break;case 2:switch(this.touches.TWO){case Ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Lt.TOUCH_DOLLY_PAN;break;case Ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Lt.TOUCH_DOLLY_ROTATE;break;default:this.state=Lt.NONE}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(yf)}function cA(i){switch(this._trackPointer(i),this.state){case Lt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Lt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Lt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Lt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Lt.NONE}}function hA(i){this.enabled!==!1&&i.preventDefault()}function uA(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function dA(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Nh(i,e){return new tn(e,new Ni({color:i}))}function Q0(i,e,t,n,s,r){let o=.16*e.length,a=new F().setFromMatrixColumn(n,0),l=new F().setFromMatrixColumn(n,1),c=new In;c.quaternion.setFromRotationMatrix(n);let h=t.getCenter(new F),u=Math.min(l.dot(t.min),l.dot(t.max))-l.dot(h);c.position.copy(h).addScaledVector(l,u-1.7*o),c.position.addScaledVector(a,(s-(r-1)/2)*2.6*o);let d=uf(i.name,.4*o,"#64748b");d.position.set(0,-1.3*o,0),c.add(d);let f=p=>p.numbers[p.first+i.numbers.value];if(i.kind==="dial"){let p=Nh(2450411,new Jn(.12*o,o,.12*o));return p.geometry.translate(0,.5*o,0),c.add(Nh(9741240,new pr(o,.05*o,12,64)),p),{object:c,shape:i,update:b=>{p.rotation.set(0,0,f(b))}}}let g=Nh(2450411,new Jn(.5*o,.5*o,.5*o));c.add(Nh(9741240,new Jn(2.2*o,.06*o,.06*o)),g);let M=null,m=1;return{object:c,shape:i,update:p=>{g.position.x=.85*o*f(p)/m},follow(p){p!==M&&(M=p,m=Math.max(p.largest(e.first+i.numbers.value),1e-12))}}}var vf=class{constructor(){this.id=0,this.object=null,this.z=0,this.renderOrder=0}},Ya=class{constructor(){this.id=0,this.v1=new Es,this.v2=new Es,this.v3=new Es,this.normalModel=new F,this.vertexNormalsModel=[new F,new F,new F],this.vertexNormalsLength=0,this.color=new nt,this.material=null,this.uvs=[new Xe,new Xe,new Xe],this.z=0,this.renderOrder=0}},Es=class{constructor(){this.position=new F,this.positionWorld=new F,this.positionScreen=new Rt,this.visible=!0}copy(e){this.positionWorld.copy(e.positionWorld),this.positionScreen.copy(e.positionScreen)}},$a=class{constructor(){this.id=0,this.v1=new Es,this.v2=new Es,this.vertexColors=[new nt,new nt],this.material=null,this.z=0,this.renderOrder=0}},Za=class{constructor(){this.id=0,this.object=null,this.x=0,this.y=0,this.z=0,this.rotation=0,this.scale=new Xe,this.material=null,this.renderOrder=0}},Uh=class{constructor(){let e,t,n=0,s,r,o=0,a,l,c=0,h,u,d=0,f,g,M=0,m,p=[],b=[],C={objects:[],lights:[],elements:[]},v=new F,R=new Rt,E=new hi(new F(-1,-1,-1),new F(1,1,1)),_=new hi,T=new Array(3),B=new gt,N=new gt,D=new gt,k=new ji,W=[],L=[],H=[],q=[],V=[],ce=[],Y=new Rt,j=new Rt,ie=new Rt,pe=[],he=[null,null,null],ee=[{sign:1},{sign:-1}];function ge(){let K=[],de=[],xe=[],Se=null,_e=new at;function $e(y){Se=y,_e.getNormalMatrix(Se.matrixWorld),K.length=0,de.length=0,xe.length=0}function P(y){let z=y.position,se=y.positionWorld,Q=y.positionScreen;se.copy(z).applyMatrix4(m),Q.copy(se).applyMatrix4(N);let me=1/Q.w;Q.x*=me,Q.y*=me,Q.z*=me,y.visible=Q.x>=-1&&Q.x<=1&&Q.y>=-1&&Q.y<=1&&Q.z>=-1&&Q.z<=1}function ue(y,z,se){s=Je(),s.position.set(y,z,se),P(s)}function ze(y,z,se){K.push(y,z,se)}function Ue(y,z,se){de.push(y,z,se)}function ye(y,z){xe.push(y,z)}function qe(y,z,se){return y.visible===!0||z.visible===!0||se.visible===!0?!0:(T[0]=y.positionScreen,T[1]=z.positionScreen,T[2]=se.positionScreen,E.intersectsBox(_.setFromPoints(T)))}function Te(y,z,se){return(se.positionScreen.x-y.positionScreen.x)*(z.positionScreen.y-y.positionScreen.y)-(se.positionScreen.y-y.positionScreen.y)*(z.positionScreen.x-y.positionScreen.x)<0}function Ge(y,z){let se=L[y],Q=L[z];se.positionScreen.copy(se.position).applyMatrix4(D),Q.positionScreen.copy(Q.position).applyMatrix4(D),qt(se.positionScreen,Q.positionScreen)===!0&&(se.positionScreen.multiplyScalar(1/se.positionScreen.w),Q.positionScreen.multiplyScalar(1/Q.positionScreen.w),h=pt(),h.id=Se.id,h.v1.copy(se),h.v2.copy(Q),h.z=Math.max(se.positionScreen.z,Q.positionScreen.z),h.renderOrder=Se.renderOrder,h.material=Se.material,Se.material.vertexColors&&(h.vertexColors[0].fromArray(de,y*3),h.vertexColors[1].fromArray(de,z*3)),C.elements.push(h))}function A(y,z,se,Q){let me=L[y],ve=L[z],te=L[se],re=me.positionScreen.w,be=ve.positionScreen.w,O=te.positionScreen.w,ae=re*(me.positionScreen.z+1),oe=be*(ve.positionScreen.z+1),Pe=O*(te.positionScreen.z+1),Ae=re*(1-me.positionScreen.z),Re=be*(1-ve.positionScreen.z),Qe=O*(1-te.positionScreen.z);if(ae<0&&oe<0&&Pe<0||Ae<0&&Re<0&&Qe<0)return;if(ae>=0&&oe>=0&&Pe>=0&&Ae>=0&&Re>=0&&Qe>=0){if(qe(me,ve,te)===!1)return;if(Q.side===Zn||Te(me,ve,te)===!0){a=ft(),a.id=Se.id,a.v1.copy(me),a.v2.copy(ve),a.v3.copy(te),a.z=(me.positionScreen.z+ve.positionScreen.z+te.positionScreen.z)/3,a.renderOrder=Se.renderOrder,v.subVectors(te.position,ve.position),R.subVectors(me.position,ve.position),v.cross(R),a.normalModel.copy(v),a.normalModel.applyMatrix3(_e).normalize();for(let le=0;le<3;le++){let Fe=a.vertexNormalsModel[le];Fe.fromArray(K,arguments[le]*3),Fe.applyMatrix3(_e).normalize(),a.uvs[le].fromArray(xe,arguments[le]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(de,y*3),C.elements.push(a)}return}Y.set(me.positionScreen.x*re,me.positionScreen.y*re,me.positionScreen.z*re,re),j.set(ve.positionScreen.x*be,ve.positionScreen.y*be,ve.positionScreen.z*be,be),ie.set(te.positionScreen.x*O,te.positionScreen.y*O,te.positionScreen.z*O,O),he[0]=Y,he[1]=j,he[2]=ie;let st=Dt(he);if(!(st<3)){for(let le=0;le<st;le++){let Fe=p[le],tt=pe[le];tt||(tt=new Es,pe[le]=tt);let Ce=1/Fe.w;tt.positionScreen.set(Fe.x*Ce,Fe.y*Ce,Fe.z*Ce,1),tt.positionWorld.copy(me.positionWorld),tt.visible=!0}for(let le=1;le<st-1;le++){let Fe=pe[0],tt=pe[le],Ce=pe[le+1];if(Q.side===Zn||Te(Fe,tt,Ce)===!0){a=ft(),a.id=Se.id,a.v1.copy(Fe),a.v2.copy(tt),a.v3.copy(Ce),a.z=(Fe.positionScreen.z+tt.positionScreen.z+Ce.positionScreen.z)/3,a.renderOrder=Se.renderOrder,v.subVectors(te.position,ve.position),R.subVectors(me.position,ve.position),v.cross(R),a.normalModel.copy(v),a.normalModel.applyMatrix3(_e).normalize();for(let lt=0;lt<3;lt++){let Gt=a.vertexNormalsModel[lt];Gt.fromArray(K,arguments[lt]*3),Gt.applyMatrix3(_e).normalize(),a.uvs[lt].fromArray(xe,arguments[lt]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(de,y*3),C.elements.push(a)}}}}return{setObject:$e,projectVertex:P,checkTriangleVisibility:qe,checkBackfaceCulling:Te,pushVertex:ue,pushNormal:ze,pushColor:Ue,pushUv:ye,pushLine:Ge,pushTriangle:A}}let Me=new ge;function Le(K){if(K.visible===!1)return;if(K.isLight)C.lights.push(K);else if(K.isMesh||K.isLine||K.isPoints){if(K.material.visible===!1||K.frustumCulled===!0&&k.intersectsObject(K)===!1)return;Ee(K)}else if(K.isSprite){if(K.material.visible===!1||K.frustumCulled===!0&&k.intersectsSprite(K)===!1)return;Ee(K)}let de=K.children;for(let xe=0,Se=de.length;xe<Se;xe++)Le(de[xe])}function Ee(K){e=ut(),e.id=K.id,e.object=K,v.setFromMatrixPosition(K.matrixWorld),v.applyMatrix4(N),e.z=v.z,e.renderOrder=K.renderOrder,C.objects.push(e)}this.projectScene=function(K,de,xe,Se){l=0,u=0,g=0,C.elements.length=0,K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),de.parent===null&&de.matrixWorldAutoUpdate===!0&&de.updateMatrixWorld(),B.copy(de.matrixWorldInverse),N.multiplyMatrices(de.projectionMatrix,B),k.setFromProjectionMatrix(N),t=0,C.objects.length=0,C.lights.length=0,Le(K),xe===!0&&C.objects.sort(Ot);let _e=C.objects;for(let $e=0,P=_e.length;$e<P;$e++){let ue=_e[$e].object,ze=ue.geometry;if(Me.setObject(ue),m=ue.matrixWorld,r=0,ue.isMesh){let Ue=ue.material,ye=Array.isArray(Ue),qe=ze.attributes,Te=ze.groups;if(qe.position===void 0)continue;let Ge=qe.position.array;for(let A=0,y=Ge.length;A<y;A+=3){let z=Ge[A],se=Ge[A+1],Q=Ge[A+2],me=ze.morphAttributes.position;if(me!==void 0){let ve=ze.morphTargetsRelative,te=ue.morphTargetInfluences;for(let re=0,be=me.length;re<be;re++){let O=te[re];if(O===0)continue;let ae=me[re];ve?(z+=ae.getX(A/3)*O,se+=ae.getY(A/3)*O,Q+=ae.getZ(A/3)*O):(z+=(ae.getX(A/3)-Ge[A])*O,se+=(ae.getY(A/3)-Ge[A+1])*O,Q+=(ae.getZ(A/3)-Ge[A+2])*O)}}Me.pushVertex(z,se,Q)}if(qe.normal!==void 0){let A=qe.normal.array;for(let y=0,z=A.length;y<z;y+=3)Me.pushNormal(A[y],A[y+1],A[y+2])}if(qe.color!==void 0){let A=qe.color.array;for(let y=0,z=A.length;y<z;y+=3)Me.pushColor(A[y],A[y+1],A[y+2])}if(qe.uv!==void 0){let A=qe.uv.array;for(let y=0,z=A.length;y<z;y+=2)Me.pushUv(A[y],A[y+1])}if(ze.index!==null){let A=ze.index.array;if(Te.length>0)for(let y=0;y<Te.length;y++){let z=Te[y];if(Ue=ye===!0?ue.material[z.materialIndex]:ue.material,Ue!==void 0)for(let se=z.start,Q=z.start+z.count;se<Q;se+=3)Me.pushTriangle(A[se],A[se+1],A[se+2],Ue)}else for(let y=0,z=A.length;y<z;y+=3)Me.pushTriangle(A[y],A[y+1],A[y+2],Ue)}else if(Te.length>0)for(let A=0;A<Te.length;A++){let y=Te[A];if(Ue=ye===!0?ue.material[y.materialIndex]:ue.material,Ue!==void 0)for(let z=y.start,se=y.start+y.count;z<se;z+=3)Me.pushTriangle(z,z+1,z+2,Ue)}else for(let A=0,y=Ge.length/3;A<y;A+=3)Me.pushTriangle(A,A+1,A+2,Ue)}else if(ue.isLine){D.multiplyMatrices(N,m);let Ue=ze.attributes;if(Ue.position!==void 0){let ye=Ue.position.array;for(let qe=0,Te=ye.length;qe<Te;qe+=3)Me.pushVertex(ye[qe],ye[qe+1],ye[qe+2]);if(Ue.color!==void 0){let qe=Ue.color.array;for(let Te=0,Ge=qe.length;Te<Ge;Te+=3)Me.pushColor(qe[Te],qe[Te+1],qe[Te+2])}if(ze.index!==null){let qe=ze.index.array;for(let Te=0,Ge=qe.length;Te<Ge;Te+=2)Me.pushLine(qe[Te],qe[Te+1])}else{let qe=ue.isLineSegments?2:1;for(let Te=0,Ge=ye.length/3-1;Te<Ge;Te+=qe)Me.pushLine(Te,Te+1)}}}else if(ue.isPoints){D.multiplyMatrices(N,m);let Ue=ze.attributes;if(Ue.position!==void 0){let ye=Ue.position.array;for(let qe=0,Te=ye.length;qe<Te;qe+=3)R.set(ye[qe],ye[qe+1],ye[qe+2],1),R.applyMatrix4(D),je(R,ue,de)}}else ue.isSprite&&(ue.modelViewMatrix.multiplyMatrices(de.matrixWorldInverse,ue.matrixWorld),R.set(m.elements[12],m.elements[13],m.elements[14],1),R.applyMatrix4(N),je(R,ue,de))}return Se===!0&&C.elements.sort(Ot),C};function je(K,de,xe){let Se=1/K.w;K.z*=Se,K.z>=-1&&K.z<=1&&(f=ot(),f.id=de.id,f.x=K.x*Se,f.y=K.y*Se,f.z=K.z,f.renderOrder=de.renderOrder,f.object=de,f.rotation=de.rotation,f.scale.x=de.scale.x*Math.abs(f.x-(K.x+xe.projectionMatrix.elements[0])/(K.w+xe.projectionMatrix.elements[12])),f.scale.y=de.scale.y*Math.abs(f.y-(K.y+xe.projectionMatrix.elements[5])/(K.w+xe.projectionMatrix.elements[13])),f.material=de.material,C.elements.push(f))}function ut(){if(t===n){let K=new vf;return W.push(K),n++,t++,K}return W[t++]}function Je(){if(r===o){let K=new Es;return L.push(K),o++,r++,K}return L[r++]}function ft(){if(l===c){let K=new Ya;return H.push(K),c++,l++,K}return H[l++]}function pt(){if(u===d){let K=new $a;return q.push(K),d++,u++,K}return q[u++]}function ot(){if(g===M){let K=new Za;return V.push(K),M++,g++,K}return V[g++]}function Ot(K,de){return K.renderOrder!==de.renderOrder?K.renderOrder-de.renderOrder:K.z!==de.z?de.z-K.z:K.id!==de.id?K.id-de.id:0}function Dt(K){p[0]=K[0],p[1]=K[1],p[2]=K[2];let de=3,xe=0;for(let Se=0;Se<ee.length;Se++){let _e=ee[Se];if(xe=0,de===0)break;for(let P=0;P<de;P++){let ue=p[P],ze=p[(P+1)%de],Ue=_e.sign*ue.z+ue.w,ye=_e.sign*ze.z+ze.w,qe=Ue>=0,Te=ye>=0;if(qe&&Te)b[xe++]=ue;else if(qe&&!Te){b[xe++]=ue;let Ge=Ue/(Ue-ye),A=ce[xe];A||(A=new Rt,ce[xe]=A),A.lerpVectors(ue,ze,Ge),b[xe++]=A}else if(!qe&&Te){let Ge=Ue/(Ue-ye),A=ce[xe];A||(A=new Rt,ce[xe]=A),A.lerpVectors(ue,ze,Ge),b[xe++]=A}}let $e=p;p=b,b=$e,de=xe}return de}function qt(K,de){let xe=0,Se=1,_e=K.z+K.w,$e=de.z+de.w,P=-K.z+K.w,ue=-de.z+de.w;return _e>=0&&$e>=0&&P>=0&&ue>=0?!0:_e<0&&$e<0||P<0&&ue<0?!1:(_e<0?xe=Math.max(xe,_e/(_e-$e)):$e<0&&(Se=Math.min(Se,_e/(_e-$e))),P<0?xe=Math.max(xe,P/(P-ue)):ue<0&&(Se=Math.min(Se,P/(P-ue))),Se<xe?!1:(K.lerp(de,xe),de.lerp(K,1-Se),!0))}}};var Oh=class{constructor(){let e,t,n,s,r,o,a,l,c,h,u,d=0,f=0,g=0,M=null,m=1,p,b,C=this,v=new Ao,R=new Ao,E=new nt,_=new nt,T=new nt,B=new nt,N=new nt,D=new nt,k=new F,W=new F,L=new F,H=new F,q=new at,V=new gt,ce=new gt,Y=[],j=[],ie=[],pe=new Uh,he=document.createElementNS("http://www.w3.org/2000/svg","svg");this.domElement=he,this.autoClear=!0,this.sortObjects=!0,this.sortElements=!0,this.overdraw=.5,this.outputColorSpace=Vn,this.info={render:{vertices:0,faces:0}},this.setQuality=function(K){switch(K){case"high":m=1;break;case"low":m=0;break}},this.setClearColor=function(K){D.set(K)},this.setPixelRatio=function(){},this.setSize=function(K,de){s=K,r=de,o=s/2,a=r/2,he.setAttribute("viewBox",-o+" "+-a+" "+s+" "+r),he.setAttribute("width",s),he.setAttribute("height",r),v.min.set(-o,-a),v.max.set(o,a)},this.getSize=function(){return{width:s,height:r}},this.setPrecision=function(K){M=K};function ee(){for(d=0;he.childNodes.length>0;)he.removeChild(he.childNodes[0])}function ge(K){return M!==null?K.toFixed(M):K}function Me(K,de){let xe=K.data.renderOrder!==void 0?K.data.renderOrder:0,Se=de.data.renderOrder!==void 0?de.data.renderOrder:0;if(xe!==Se)return xe-Se;{let _e=K.data.z!==void 0?K.data.z:0;return(de.data.z!==void 0?de.data.z:0)-_e}}this.clear=function(){ee(),he.style.backgroundColor=D.getStyle(C.outputColorSpace)},this.render=function(K,de){if(!(de instanceof mr)){console.error("THREE.SVGRenderer.render: camera is not an instance of Camera.");return}let xe=K.background;xe&&xe.isColor?(ee(),he.style.backgroundColor=xe.getStyle(C.outputColorSpace)):this.autoClear===!0&&this.clear(),C.info.render.vertices=0,C.info.render.faces=0,V.copy(de.matrixWorldInverse),ce.multiplyMatrices(de.projectionMatrix,V),e=pe.projectScene(K,de,this.sortObjects,this.sortElements),t=e.elements,n=e.lights,q.getNormalMatrix(de.matrixWorldInverse),Le(n),g=0;for(let Se=0,_e=t.length;Se<_e;Se++){let $e=t[Se],P=$e.material;P===void 0||P.opacity===0||qt(g++,"element",$e,P)}f=0,K.traverseVisible(function(Se){if(Se.isSVGObject){if(k.setFromMatrixPosition(Se.matrixWorld),k.applyMatrix4(ce),k.z<-1||k.z>1)return;let _e=k.x*o,$e=-k.y*a,P=Dt(f++);P.node=Se.node,P.x=_e,P.y=$e,P.z=k.z,P.renderOrder=Se.renderOrder,qt(g++,"svgObject",P,null)}}),ie.length=g,this.sortElements&&f>0&&ie.sort(Me),p="",b="";for(let Se=0;Se<g;Se++){let _e=ie[Se];if(_e.type==="svgObject"){ot();let $e=_e.data,P=$e.node;P.setAttribute("transform","translate("+$e.x+","+$e.y+")"),he.appendChild(P)}else{let $e=_e.data,P=_e.material;R.makeEmpty(),$e instanceof Za?(l=$e,l.x*=o,l.y*=-a,je(l,$e,P)):$e instanceof $a?(l=$e.v1,c=$e.v2,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,R.setFromPoints([l.positionScreen,c.positionScreen]),v.intersectsBox(R)===!0&&ut(l,c,P)):$e instanceof Ya&&(l=$e.v1,c=$e.v2,h=$e.v3,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,h.positionScreen.x*=o,h.positionScreen.y*=-a,this.overdraw>0&&(ft(l.positionScreen,c.positionScreen,this.overdraw),ft(c.positionScreen,h.positionScreen,this.overdraw),ft(h.positionScreen,l.positionScreen,this.overdraw)),R.setFromPoints([l.positionScreen,c.positionScreen,h.positionScreen]),v.intersectsBox(R)===!0&&Je(l,c,h,$e,P))}}ot()};function Le(K){T.setRGB(0,0,0),B.setRGB(0,0,0),N.setRGB(0,0,0);for(let de=0,xe=K.length;de<xe;de++){let Se=K[de],_e=Se.color;Se.isAmbientLight?(T.r+=_e.r,T.g+=_e.g,T.b+=_e.b):Se.isDirectionalLight?(B.r+=_e.r,B.g+=_e.g,B.b+=_e.b):Se.isPointLight&&(N.r+=_e.r,N.g+=_e.g,N.b+=_e.b)}}function Ee(K,de,xe,Se){for(let _e=0,$e=K.length;_e<$e;_e++){let P=K[_e],ue=P.color;if(P.isDirectionalLight){let ze=k.setFromMatrixPosition(P.matrixWorld).sub(W.setFromMatrixPosition(P.target.matrixWorld)).normalize(),Ue=xe.dot(ze);if(Ue<=0)continue;Ue*=P.intensity,Se.r+=ue.r*Ue,Se.g+=ue.g*Ue,Se.b+=ue.b*Ue}else if(P.isPointLight){let ze=k.setFromMatrixPosition(P.matrixWorld),Ue=xe.dot(k.subVectors(ze,de).normalize());if(Ue<=0||(Ue*=P.distance==0?1:1-Math.min(de.distanceTo(ze)/P.distance,1),Ue==0))continue;Ue*=P.intensity,Se.r+=ue.r*Ue,Se.g+=ue.g*Ue,Se.b+=ue.b*Ue}}}function je(K,de,xe){let Se=de.scale.x*o,_e=de.scale.y*a;xe.isPointsMaterial&&(Se*=xe.size,_e*=xe.size);let $e="M"+ge(K.x-Se*.5)+","+ge(K.y-_e*.5)+"h"+ge(Se)+"v"+ge(_e)+"h"+ge(-Se)+"z",P="";(xe.isSpriteMaterial||xe.isPointsMaterial)&&(P="fill:"+xe.color.getStyle(C.outputColorSpace)+";fill-opacity:"+xe.opacity),pt(P,$e)}function ut(K,de,xe){let Se="M"+ge(K.positionScreen.x)+","+ge(K.positionScreen.y)+"L"+ge(de.positionScreen.x)+","+ge(de.positionScreen.y);if(xe.isLineBasicMaterial){let _e="fill:none;stroke:"+xe.color.getStyle(C.outputColorSpace)+";stroke-opacity:"+xe.opacity+";stroke-width:"+xe.linewidth+";stroke-linecap:"+xe.linecap;xe.isLineDashedMaterial&&(_e=_e+";stroke-dasharray:"+xe.dashSize+","+xe.gapSize),pt(_e,Se)}}function Je(K,de,xe,Se,_e){C.info.render.vertices+=3,C.info.render.faces++;let $e="M"+ge(K.positionScreen.x)+","+ge(K.positionScreen.y)+"L"+ge(de.positionScreen.x)+","+ge(de.positionScreen.y)+"L"+ge(xe.positionScreen.x)+","+ge(xe.positionScreen.y)+"z",P="";_e.isMeshBasicMaterial?(E.copy(_e.color),_e.vertexColors&&E.multiply(Se.color)):_e.isMeshLambertMaterial||_e.isMeshPhongMaterial||_e.isMeshStandardMaterial?(_.copy(_e.color),_e.vertexColors&&_.multiply(Se.color),E.copy(T),L.copy(K.positionWorld).add(de.positionWorld).add(xe.positionWorld).divideScalar(3),Ee(n,L,Se.normalModel,E),E.multiply(_).add(_e.emissive)):_e.isMeshNormalMaterial&&(H.copy(Se.normalModel).applyMatrix3(q).normalize(),E.setRGB(H.x,H.y,H.z).multiplyScalar(.5).addScalar(.5)),_e.wireframe?P="fill:none;stroke:"+E.getStyle(C.outputColorSpace)+";stroke-opacity:"+_e.opacity+";stroke-width:"+_e.wireframeLinewidth+";stroke-linecap:"+_e.wireframeLinecap+";stroke-linejoin:"+_e.wireframeLinejoin:P="fill:"+E.getStyle(C.outputColorSpace)+";fill-opacity:"+_e.opacity,pt(P,$e)}function ft(K,de,xe){let Se=de.x-K.x,_e=de.y-K.y,$e=Se*Se+_e*_e;if($e===0)return;let P=xe/Math.sqrt($e);Se*=P,_e*=P,de.x+=Se,de.y+=_e,K.x-=Se,K.y-=_e}function pt(K,de){b===K?p+=de:(ot(),b=K,p=de)}function ot(){p&&(u=Ot(d++),u.setAttribute("d",p),u.setAttribute("style",b),he.appendChild(u)),p="",b=""}function Ot(K){let de=Y[K];return de===void 0&&(de=document.createElementNS("http://www.w3.org/2000/svg","path"),m==0&&de.setAttribute("shape-rendering","crispEdges"),Y[K]=de),de}function Dt(K){let de=j[K];return de===void 0&&(de={node:null,x:0,y:0,z:0,renderOrder:0},j[K]=de),de}function qt(K,de,xe,Se){let _e=ie[K];return _e===void 0?(_e={type:de,data:xe,material:Se},ie[K]=_e,_e):(_e.type=de,_e.data=xe,_e.material=Se,_e)}}};function e_(i,e,t,n){let s=[],r=[];i.traverseVisible(l=>{l instanceof Di&&r.push(l),((l instanceof ys||l instanceof Mo)&&(l.geometry.getAttribute("position")?.count??0)===0||l instanceof Di||l instanceof tn&&l.geometry.getAttribute("position")===void 0)&&s.push(l)});for(let l of s)l.visible=!1;let o=new Oh;o.setSize(t,n),o.setClearColor(i.background instanceof nt?i.background:new nt("white"),1),o.setPrecision(2),o.render(i,e);for(let l of s)l.visible=!0;let a=o.domElement;a.setAttribute("xmlns","http://www.w3.org/2000/svg");for(let l of r){let c=l.getWorldPosition(new F).project(e),h=document.createElementNS("http://www.w3.org/2000/svg","text");h.textContent=`${l.userData.words}`;let u={x:c.x*t/2,y:-c.y*n/2,"text-anchor":"middle","font-family":"sans-serif","font-size":12,fill:"#64748b"};for(let[d,f]of Object.entries(u))h.setAttribute(d,`${f}`);a.append(h)}return new XMLSerializer().serializeToString(a)}var fA=250,pA=2e3,mA=4,gA=24,t_=2,_A=.75;function xA(i){let e=i.getExtension("WEBGL_debug_renderer_info"),t=i.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}var Fh=class{constructor(e){this.redraw=e;let t={alpha:!1,depth:!0,stencil:!1,preserveDrawingBuffer:!0},n=document.createElement("canvas"),s=n.getContext("webgl2",{...t,antialias:!1});s!==null&&xA(s)?(this.software=!0,this.renderer=new za({canvas:n,context:s,...t})):(this.software=!1,s?.getExtension("WEBGL_lose_context")?.loseContext(),this.renderer=new za({...t,antialias:!0})),this.canvas=this.renderer.domElement,this.fine=!this.software,this.ratio()}redraw;canvas;renderer;software;fine=!0;film=!1;rest=0;before=0;veil=new tn(new fr(2,2),new bo({transparent:!0,opacity:_A,depthTest:!1}));detail(e){return this.software?Math.min(1,Math.sqrt(gA/Math.max(e,1))):1}size(e,t){this.renderer.setSize(e,t)}draw(e,t){this.software&&this.soften(),this.renderer.render(e,t)}pair(e,t,n,s){this.software&&this.soften();let{renderer:r}=this,{background:o}=e,{x:a,y:l}=r.getSize(new Xe);r.autoClear=!1,r.setScissorTest(n),s.forEach((c,h)=>{c(),n?(r.setViewport(h*a/2,0,a/2,l),r.setScissor(h*a/2,0,a/2,l)):h===1&&(this.veil.material.color=o,r.render(new ur().add(this.veil),new Ui(-1,1,1,-1,-1,1)),r.clearDepth(),e.background=null),r.render(e,t)}),e.background=o,r.setScissorTest(!1),r.setViewport(0,0,a,l),r.autoClear=!0}filming(e){clearTimeout(this.rest),this.rest=e?-1:0,this.film=e}soften(){let e=this.rest<0;this.fine!==e&&(this.fine=e,this.ratio()),clearTimeout(this.rest);let t=performance.now(),n=Math.min(Math.max(mA*(t-this.before),fA),pA);this.before=t,this.rest=this.film?-1:e?0:setTimeout(()=>{this.rest=-1,this.redraw()},n)}ratio(){let e=Math.min(window.devicePixelRatio,t_);this.renderer.setPixelRatio(this.software?this.fine?t_:Math.min(e,1):e)}};var yA=200,n_=new Set(["trace","ground","frame","slider","dial","text"]),i_=new Set(["box","cylinder","cone","disc","sphere","mass","body","circle","mesh"]),vA=new Set(["rod","spring","damper","rope"]),bA=19,s_=13,MA=.05,SA=20,kh=class{constructor(e,t,n,s){this.head=e;this.place=s;this.motion=t,this.screen=new Fh(()=>this.render()),this.canvas=this.screen.canvas,this.canvas.setAttribute("role","img"),this.canvas.setAttribute("aria-label",`The machine ${e.name}, moving`),s.append(this.canvas),this.box=bf(e,t);let r=Math.max(this.box.getSize(new F).length()/Math.SQRT2,1e-9);this.sizes={...TA(e,t,r,this.box.getCenter(new F)),meshes:n,detail:this.screen.detail(e.scene.shapes.length)},this.camera=e.planar?new Ui:new Xn(35,1,r/100,r*100),this.camera.up.set(...e.up),this.controls=new Dh(this.camera,this.canvas),this.controls.enableRotate=!e.planar,this.controls.addEventListener("change",()=>this.render()),this.controls.addEventListener("start",()=>this.moved=!0),this.scene.add(new Ta(16777215,.7),new Sa(16777215,9741240,1.2));let o=new wa(16777215,2);o.position.set(.6,1,1.2),this.camera.add(o),this.scene.add(this.camera,this.ghosts),this.furnish(),this.surround(),this.grid=this.ground(r),this.scene.add(this.grid);let{arrows:a}=this;e.planar&&(a.position.z=2*r),this.scene.add(a),this.overlay=e.vectors?new Ah(e.vectors,this.sizes,a):null,this.theme(),this.aim(),new ResizeObserver(()=>{(s.clientWidth!==this.canvas.clientWidth||s.clientHeight!==this.canvas.clientHeight)&&this.resize()}).observe(s)}head;place;canvas;screen;scene=new ur;camera;controls;drawn=[];box;sizes;grid;ghosts=new In;arrows=new In;shown={forces:!0,frames:!1};overlay;moved=!1;now=null;other=null;onlyGauges=!1;motion;furnish(){let e=this.head.scene.shapes.filter(Bh),t=this.box.clone();for(let n of this.head.scene.shapes){let s=Bh(n)?Q0(n,this.sizes,t,this.facing(),e.indexOf(n),e.length):Th[n.kind]?.(n,this.sizes);s!==void 0&&(s.object.traverse(r=>r.userData.shape=n),this.drawn.push(s),this.scene.add(s.object))}this.onlyGauges=e.length>0&&this.head.scene.shapes.every(n=>Bh(n)||n_.has(n.kind)),this.show()}enclose(e){let t=this.drawn.filter(({shape:s})=>i_.has(s.kind)),n=new Float64Array(e.width);for(let s=0;s<s_&&e.count>0;++s){let r=Math.round((e.count-1)*s/(s_-1));e.state(e.at(r,0),n);for(let o of t)o.update({numbers:n,first:this.head.scene.first}),o.object.updateMatrixWorld(!0),o.object.visible&&this.box.expandByObject(o.object)}}follow(e){if(this.motion=e,this.moved||this.onlyGauges)return;let t=this.box.clone().expandByScalar(MA*this.sizes.length),n=bf(this.head,e);t.containsBox(n)||n.union(this.box).getSize(new F).length()>SA*this.sizes.length||(this.box.union(n),this.enclose(e),this.aim())}facing(){let e=new F(...this.head.up);if(this.head.planar)return new gt;let t=Math.abs(e.z)>.7?new F(.75,-1,0):new F(.6,0,1);return t.addScaledVector(e,-t.dot(e)).normalize(),new gt().makeBasis(new F().crossVectors(e,t),e,t)}show(){for(let{object:e,shape:t}of this.drawn)t.kind==="frame"&&(e.visible=this.shown.frames),(t.kind==="force"||t.kind==="torque")&&(e.userData.hidden=!this.shown.forces)}ground(e){let t=10**Math.floor(Math.log10(e/2)),n=2*Math.ceil(1.5*e/t),s=new Ea(n*t,n),r=this.box.getCenter(new F);this.head.planar?s.rotation.x=Math.PI/2:s.quaternion.setFromUnitVectors(new F(0,1,0),new F(...this.head.up));let o=new F(...this.head.up);if(this.head.planar)s.position.set(r_(r.x,t),r_(r.y,t),-.2*e);else{let a=Math.min(o.dot(this.box.min),o.dot(this.box.max));s.position.copy(r).addScaledVector(o,a-o.dot(r)-.02*e)}return s}lookAt(){this.moved=!1,this.surround(),this.aim()}surround(){this.onlyGauges?this.box.makeEmpty():(this.box.copy(bf(this.head,this.motion)),this.enclose(this.motion));for(let{object:e,shape:t}of this.drawn)Bh(t)&&this.box.expandByObject(e)}aim(){let e=this.box.getSize(new F).length()/Math.SQRT2;this.grid.scale.setScalar(Math.max(Vr(.8*e/this.sizes.length),1)),this.controls.target.copy(this.box.getCenter(new F)),this.resize(),this.controls.update()}fit(e){let t=this.box.getCenter(new F),{length:n}=this.sizes;if(this.camera instanceof Ui){let h=this.box.getSize(new F),u=.12*Math.max(h.x,h.y,.2*n),d=Math.max(h.y/2+u,(h.x/2+u)/e);if(Object.assign(this.camera,{top:d,bottom:-d,right:d*e,left:-d*e}),this.moved)return;Object.assign(this.camera,{near:.1*n,far:30*n,zoom:1}),this.camera.position.copy(t).add(new F(0,0,10*n));return}if(this.camera.aspect=e,this.moved)return;let s=this.facing(),r=new F(0,.38,.92).transformDirection(s),o=new F().setFromMatrixColumn(s,0),a=new F().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360)/1.12,c=0;for(let h=0;h<8;++h){let u=new F(...[0,1,2].map(f=>(h>>f&1?this.box.max:this.box.min).getComponent(f)));u.sub(t);let d=Math.max(Math.abs(u.dot(o))/e,Math.abs(u.dot(a)));c=Math.max(c,u.dot(r)+d/l)}this.camera.position.copy(t).addScaledVector(r,Math.max(c,.5*n))}resize(){let{clientWidth:e,clientHeight:t}=this.place;e===0||t===0||(this.screen.size(e,t),this.fit((this.other?.beside?.5:1)*(e/t)),this.camera.updateProjectionMatrix(),this.controls.update(),this.legible(t),this.render())}legible(e){let{camera:t}=this,n=t.position.distanceTo(this.box.getCenter(new F)),s=t instanceof Ui?t.top-t.bottom:2*n*Math.tan(t.fov*Math.PI/360),r=bA*s/e;this.scene.traverse(o=>{if(!(o instanceof Di))return;let a=o.userData.height??=o.scale.y;o.scale.multiplyScalar(Math.max(a,r)/o.scale.y)})}theme(){let e=getComputedStyle(document.documentElement);this.scene.background=new nt(e.getPropertyValue("--stage").trim());let t=new nt(e.getPropertyValue("--grid").trim());for(let n of[this.grid.material].flat())n.vertexColors=!1,n.color=t,n.needsUpdate=!0;this.render()}pose(e,t,n){this.now={motion:e,numbers:t,t:n},this.overlay?.pose(n),this.set(e,t,n),this.render()}set(e,t,n){let s={numbers:t,first:this.head.scene.first},r=e.rowAt(n);for(let o of this.drawn)o.follow?.(e,r),o.update(s),o.object.userData.hidden&&(o.object.visible=!1),o.object.updateMatrixWorld(!0)}compare(e,t){this.other=e===null?null:{motion:e,numbers:new Float64Array(e.width),beside:t},this.resize()}postures(e,t){this.ghosts.clear();let n=new Float64Array(e.width);for(let s of t){e.state(s,n);for(let r of this.drawn){if(n_.has(r.shape.kind)||(r.update({numbers:n,first:this.head.scene.first}),!r.object.visible||r.object.userData.hidden))continue;let o=r.object.clone();o.traverse(a=>{if(!(a instanceof tn))return;let l=a.material.clone();Object.assign(l,{transparent:!0,opacity:.22,depthWrite:!1}),a.material=l,a.userData.bent&&(a.geometry=a.geometry.clone())}),this.ghosts.add(o)}}this.ghosts.updateMatrixWorld(!0)}sketch(){return e_(this.scene,this.camera,this.place.clientWidth,this.place.clientHeight)}render(){let{now:e,other:t}=this;if(e===null)return;if(t===null){this.screen.draw(this.scene,this.camera);return}let n=r=>{this.arrows.visible=this.ghosts.visible=!r},s=Math.min(e.t,t.motion.last);this.screen.pair(this.scene,this.camera,t.beside,[()=>{n(!0),this.set(t.motion,t.motion.state(s,t.numbers),s)},()=>{n(!1),this.set(e.motion,e.numbers,e.t)}])}filming(e){this.screen.filming(e)}ray(e,t){let n=this.canvas.getBoundingClientRect(),s=(e-n.left)/n.width,r=new Xe((this.other?.beside?2*s%1:s)*2-1,1-(t-n.top)/n.height*2),o=new Aa;return o.setFromCamera(r,this.camera),o}held(e,t){let n=this.hitAt(e,t),s=n?.object.userData.shape;if(n===void 0||s===void 0||this.now===null||!(s.kind==="dial"||i_.has(s.kind)||vA.has(s.kind)))return null;if(s.kind==="dial")return{shape:s,parts:[],point:this.drawn.find(h=>h.shape===s)?.object.position??n.point};let r={numbers:this.now.numbers,first:this.head.scene.first},o=h=>r.first+s.numbers[h],a=n.point.clone().sub(yt(s,"at",r));if("to"in s.numbers){let h=yt(s,"to",r).sub(yt(s,"at",r)),u=a.dot(h)/Math.max(h.lengthSq(),1e-300);return{shape:s,parts:[[o("at"),1-u],[o("to"),u]],point:yt(s,"at",r).addScaledVector(h,u)}}let l=["x","y","z"].filter(h=>h in s.numbers),c=l.map(h=>[o(h),a.dot(yt(s,h,r))]);return{shape:s,parts:[[o("at"),1],...c],point:l.length>0?n.point:yt(s,"at",r)}}facingPlace(e,t,n){let[s,r,o]=[0,1,2].map(l=>new F().setFromMatrixColumn(this.camera.matrixWorld,l)),a=new Wn().setFromNormalAndCoplanarPoint(o,n);return{place:this.ray(e,t).ray.intersectPlane(a,new F)??n,across:[s,r]}}get length(){return this.sizes.length}hitAt(e,t){let n=(this.overlay?.drawn??[]).filter(r=>r.object.visible),s=[...this.drawn,...n].map(r=>r.object);return this.ray(e,t).intersectObjects(s).find(r=>r.object.visible)}shapeAt(e,t){return this.hitAt(e,t)?.object.userData.shape??null}value(e,t){if(this.overlay?.drawn.some(s=>s.shape===e))return this.overlay.value(e);if(e.kind!=="force"&&e.kind!=="torque")return"";let n=yt(e,"vector",{numbers:t,first:this.head.scene.first}).length();return`${qa(n)} ${Ts(e)}`}highlight(e){for(let t of[...this.drawn,...this.overlay?.drawn??[]])t.object.traverse(n=>{n instanceof tn&&n.material instanceof Ni&&n.material.emissive.setHex(e.includes(t.shape)?8016384:0)});this.render()}};function Bh(i){return i.kind==="slider"||i.kind==="dial"}function r_(i,e){return Math.round(i/e)*e}function wA(i,e,t){let n=(r,o=0)=>r in e.numbers?t.at(0,i.scene.first+e.numbers[r]+o):0;if(t.count===0)return 0;if(e.kind!=="body")return Math.max(n("radius"),.5*n("length"),.5*n("height"));let s=2.5*(n("inertia")+n("inertia",1)+n("inertia",2))/n("mass");return s>0&&Number.isFinite(s)?.6*Math.sqrt(s):0}function bf(i,e){let t=new hi,n=new F,s=Math.max(1,Math.floor(e.count/yA));for(let o of i.scene.shapes)if(o.kind!=="frame")for(let a of["at","to"]){if(!(a in o.numbers))continue;let l=i.scene.first+o.numbers[a],c=wA(i,o,e);for(let h=0;h<e.count;h+=s)n.set(e.at(h,l),e.at(h,l+1),e.at(h,l+2)),Number.isFinite(n.x+n.y+n.z)&&t.expandByPoint(n.clone().addScalar(c)).expandByPoint(n.clone().addScalar(-c))}return t.isEmpty()&&t.set(new F(0,0,0),new F(0,0,0)),t.getSize(n).length()===0&&t.expandByScalar(.5),t}function TA(i,e,t,n){let s=(o,a,l)=>{let c=0;for(let h of i.scene.shapes){if(h.kind!==o||!(a in h.numbers))continue;let u=i.scene.first+h.numbers[a];for(let d=0;d<e.count;++d){let f=0;for(let g=0;g<l;++g)f+=e.at(d,u+g)**2;Number.isFinite(f)&&(c=Math.max(c,Math.sqrt(f)))}}return c},r=o=>o>0?.3*t/o:0;return{length:t,mass:s("mass","mass",1),force:r(s("force","vector",3)),torque:r(s("torque","vector",3)),planar:i.planar,first:i.scene.first,center:n}}function o_(i){let e=[...document.querySelectorAll("[role=tab]")],t=n=>{for(let s of e)s.ariaSelected=`${s===n}`,s.tabIndex=s===n?0:-1,document.getElementById(s.getAttribute("aria-controls")??"")?.toggleAttribute("hidden",s!==n);i()};e.forEach((n,s)=>{n.onclick=()=>t(n),n.onkeydown=r=>{let o=r.key==="ArrowRight"?1:r.key==="ArrowLeft"?-1:0;if(o===0)return;r.stopPropagation();let a=e[(s+o+e.length)%e.length];t(a),a.focus()}}),t(e[0])}var zh=class{terms;pinned=null;constructor(e,t,n,s){this.terms=[...t.querySelectorAll("[data-from]")].map(r=>{let a=(r.getAttribute("data-from")??"").split(" ").filter(l=>l!=="").map(l=>e.sources[Number(l)]).filter(l=>l!==null);return{element:r,spans:a}});for(let{element:r,spans:o}of this.terms)r.addEventListener("pointerenter",()=>{this.mark(null),r.classList.add("marked"),n(o)}),r.addEventListener("pointerleave",()=>{this.mark(null),n([])}),r.addEventListener("click",()=>s(o))}first(e){return this.terms.find(({spans:t})=>t.some(n=>Gh(n,e)))?.element??null}pin(e){this.pinned=e,this.mark(null)}mark(e){let t=[e,this.pinned].filter(n=>n!==null);for(let{element:n,spans:s}of this.terms)n.classList.toggle("marked",s.some(r=>t.some(o=>Gh(r,o))))}};function Gh(i,e){return a_(i.first,e.last)&&a_(e.first,i.last)}function a_(i,e){return i[0]<e[0]||i[0]===e[0]&&i[1]<e[1]}function Mf(i){return(e,t,n)=>{let s=et("button",{textContent:e,title:t,onclick:n});return i.append(s),s}}function l_(i,e){let t=et("div",{onclick:()=>n.open=!1}),n=et("details",{className:"menu"},et("summary",{textContent:e}),t);return i.append(n),document.addEventListener("pointerdown",s=>{s.target instanceof Node&&n.contains(s.target)||(n.open=!1)}),t}var c_=601,h_=5,Hh=72,AA=480,EA=500,u_="Keys: space play and pause, arrows step, Home and End, + and - speed, g ghosts, v velocities, f the whole machine, k keep this motion, p present",CA=["one motion","kept one behind","kept one beside"],Sf=class{constructor(e,t,n){this.head=e;this.motions=t;this.stage=n;let[s]=t;this.motion=s,this.events=e.events,this.numbers=new Float64Array(s.width),this.player=new Eh(e,Xt("player"),o=>this.pose(o)),this.sliders=new Ph(e,Du(t),Xt("sliders"),()=>this.again()),this.influence=new wl(e,Xt("sliders")),this.curves=new bl(e,s,Xt("curves"),o=>this.player.go(o)),this.source=new Ih(e,Xt("source"),o=>this.follow(o),o=>this.toTerms(o)),this.terms=new zh(e,Xt("derivation"),o=>this.mark(o),o=>this.toSource(o)),this.cells=this.values();let r=Xt("units");r.onchange=()=>Xt("derivation").classList.toggle("units",r.checked),o_(()=>{this.tell(),this.source.pin([]),this.terms.pin(null)}),this.tools(),this.keys(),this.pointer(),Em(e,n,Xt("stage"),{ready:()=>this.live!==null,begin:()=>this.startHere(),pull:o=>this.again(o),turn:(o,a)=>this.sliders.set(o,a)}),location.hash==="#present"&&this.present(!0),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.stage.theme()),this.say(e.said),this.pose(e.start),this.tell(),window.addEventListener("beforeprint",()=>this.tell()),e.modes!==void 0&&(Xt("sliders-tab").textContent="Modes"),new Ch(e,Xt("sliders"),o=>this.choose(o)),t.length>1&&e.modes===void 0&&this.curves.behind(t)}head;motions;stage;motion;numbers;player;sliders;influence;curves;source;terms;cells;live=null;ghosts=!1;kept=null;events;arrows=null;endFilm=null;comparing=et("select");ghostly=null;speedy=null;async begin(){this.live=await or.begin(this.head,c_,e=>this.arrived(e));for(let e of Xt("sliders").querySelectorAll(":scope > :not(#runs)"))e.toggleAttribute("inert",this.live===null),e.hidden=this.head.live===!1;this.live===null&&this.head.live!==!1&&this.say("This browser shows the recorded motion only: sliders need WebAssembly."),this.live!==null&&this.influence.rest(this.sliders.parameters,this.sliders.inputs),document.documentElement.dataset.ready=this.live===null?"recorded":"live",matchMedia("(prefers-reduced-motion: reduce)").matches||this.player.play()}choose(e){let t=this.head.runs?.[e];t!==void 0&&(this.motion=this.motions[e],this.events=t.events,this.player.over(t.start,t.stop,t.pace),this.player.mark(t.events),this.curves.show(this.motion,t.events),t.parameters!==null&&this.sliders.take(t.parameters),this.say(t.said===""?t.label:`${t.label}: ${t.said}`),this.stage.follow(this.motion),this.haunt(),this.pose(this.player.time),t.parameters!==null&&t.said===""&&this.again())}haunt(){let{last:e}=this.motion,t=this.motion.count>0?this.motion.at(0,0):0,n=Array.from({length:h_},(s,r)=>t+(e-t)*r/(h_-1));this.stage.postures(this.motion,this.ghosts?n:[])}pose(e){let t=Math.min(e,this.motion.last);this.motion.state(t,this.numbers),this.stage.pose(this.motion,this.numbers,t),this.legend(),this.curves.point(t),Xt("table-panel").hidden||this.tell()}tell(){this.cells.forEach((e,t)=>e.textContent=_f(this.head.columns[t],this.numbers[t]))}again(e=null){this.influence.rest(this.sliders.parameters,this.sliders.inputs),this.live?.run(this.sliders.parameters,this.sliders.inputs,e),this.arrows?.then(t=>t?.run(this.sliders.parameters,this.sliders.inputs))}startHere(){this.player.pause(),this.head.columns.forEach(({name:e,kind:t},n)=>{t==="coordinate"&&this.sliders.put(`${e}.start`,this.numbers[n])}),this.player.go(-1/0)}compare(e){this.kept=e===0?null:this.kept??this.motion,this.stage.compare(this.kept,e===2),this.curves.behind(this.kept===null?this.head.modes===void 0?this.motions.slice(1):[]:[this.kept]),this.pose(this.player.time)}present(e){document.documentElement.toggleAttribute("data-present",e),e&&location.hash!=="#present"?document.documentElement.requestFullscreen?.().catch(()=>{}):document.fullscreenElement!==null&&document.exitFullscreen()}async point(e,t){let n=this.stage.overlay;if(n!==null){if(t?n.shown.add(e):n.shown.delete(e),t&&this.arrows===null){let s=({motion:r})=>{n.take(r),document.documentElement.dataset.arrows=`${r.count}`,this.pose(this.player.time)};this.arrows=or.begin(this.head,c_,s,{tape:"vectors"}),await this.arrows===null&&this.say("Arrows need WebAssembly."),this.again()}this.pose(this.player.time)}}mark(e){let t=this.head.scene.shapes.filter(({span:n})=>n!==null&&e.some(s=>Gh(s,n)));this.stage.highlight(t),this.source.mark(e),Xt("pointed").textContent=t.map(n=>n.name).join(", ")}follow(e){this.mark(e===null?[]:[e]),this.terms.mark(e)}toSource(e){Xt("source-tab").click(),this.source.pin(e)}toTerms(e){let t=this.terms.first(e);if(t===null){this.say("No term of the equations comes from this line.");return}Xt("derivation-tab").click(),this.terms.pin(e),t.scrollIntoView({block:"center"})}fit(){this.stage.lookAt(),this.pose(this.player.time)}legend(){let e=(this.stage.overlay?.legend()??[]).join(`
`),t=Xt("legend");t.textContent!==e&&(t.textContent=e)}arrived({motion:e,status:t,time:n,took:s,parameters:r,events:o,blamed:a}){let l=e.count===0;document.documentElement.toggleAttribute("data-failed",l),l?this.player.pause():(this.motion=e,this.events=o.map(([c,h,u])=>{let{kind:d,names:f}=this.head.event_names[h];return{time:c,kind:d,name:f[u]??""}}),this.sliders.take(r),this.curves.show(e,this.events),this.player.mark(this.events),this.stage.follow(e),this.haunt(),this.pose(this.player.time)),document.documentElement.dataset.took=s.toFixed(2),t===0?this.say(`Integrated anew in ${s.toFixed(1)} ms.`):t===-1?this.say(`This motion takes long; it is shown up to ${n.toPrecision(4)} s.`):this.say(`${l?"This start cannot be. ":""}${Sl(this.head,t,a)} (t = ${n.toPrecision(5)} s)`)}say(e){Xt("said").textContent=e}values(){let e=Xt("values");return this.head.columns.slice(0,this.head.scene.first).map(t=>{let n=et("td"),s=et("th",{scope:"row",textContent:t.name});return e.append(et("tr",{},s,n,et("td",{textContent:t.display.unit}))),n})}tools(){let e=Mf(Xt("tools")),t=(n,s)=>{let r=e(n,s,()=>{this.stage.shown[n]=!this.stage.shown[n],r.ariaPressed=`${this.stage.shown[n]}`,this.stage.show(),this.pose(this.player.time)});r.ariaPressed=`${this.stage.shown[n]}`};this.head.scene.shapes.some(({kind:n})=>n==="force"||n==="torque")&&t("forces","Arrows of loads"),this.switches(e),this.head.scene.shapes.some(({kind:n})=>n==="frame")&&t("frames","Axes of frames"),this.ghostly=e("ghosts","Pale postures of several instants (key g)",()=>this.toggleGhosts()),this.ghostly.ariaPressed="false",e("fit","The whole machine (key f)",()=>this.fit()),e("present","The picture alone, in large type (key p)",()=>this.present(!0)),e("keys",u_,()=>this.say(u_)),this.comparing.title="Keep this motion (key k), and see it with the next ones",this.comparing.ariaLabel=this.comparing.title,this.comparing.append(...CA.map((n,s)=>new Option(n,`${s}`))),this.comparing.onchange=()=>this.compare(Number(this.comparing.value)),Xt("tools").append(this.comparing),this.saving()}saving(){let e=Mf(l_(Xt("tools"),"save"));if(e("PNG","The picture",()=>Mm(this.stage.canvas,this.head)),e("SVG","The picture as lines and faces",()=>Wr(new Blob([this.stage.sketch()],{type:"image/svg+xml"}),`${this.head.name}.svg`)),e("GIF","The motion as a film that plays everywhere",()=>{this.filmed()}),e("CSV","The values",()=>Sm(this.motion,this.head)),typeof MediaRecorder>"u")return;let t=e("film","Record what plays",()=>{this.endFilm===null?(this.endFilm=wm(this.stage.canvas,this.head),this.player.play()):(this.endFilm(),this.endFilm=null),t.ariaPressed=`${this.endFilm!==null}`})}switches(e){let t=this.stage.overlay;if(t===null)return;for(let[r,o,a]of q0){if(!t.has(r))continue;let l=e(o,a,()=>{let c=!t.shown.has(r);l.ariaPressed=`${c}`,this.point(r,c),r==="admissible"&&(s.hidden=!c)});l.ariaPressed="false",r==="velocity"&&(this.speedy=l)}let n="The coordinate that moves",s=et("select",{title:n,ariaLabel:n,hidden:!0});s.append(new Option("all coordinates",""),...t.coordinates.map(r=>new Option(r,r))),s.onchange=()=>{t.coordinate=s.value,this.pose(this.player.time)},Xt("tools").append(s)}toggleGhosts(){this.ghosts=!this.ghosts,this.ghostly!==null&&(this.ghostly.ariaPressed=`${this.ghosts}`),this.haunt(),this.pose(this.player.time)}async filmed(){this.player.pause();let{canvas:e}=this.stage,t=Math.min(AA,e.width),n=et("canvas",{width:t,height:Math.round(t*e.height/e.width)}),s=n.getContext("2d",{willReadFrequently:!0});if(s===null)return;Object.assign(s,{imageSmoothingQuality:"high"}),this.stage.filming(!0);let{time:r}=this.player,o=this.motion.at(0,0),a=this.motion.last-o,l=[];for(let h=0;h<Hh;++h)this.pose(o+a*h/(Hh-1)),s.drawImage(e,0,0,n.width,n.height),l.push(s.getImageData(0,0,n.width,n.height)),h%8===0&&(this.say(`Film: ${h+1} of ${Hh} pictures`),await new Promise(u=>setTimeout(u)));let c=Math.min(Math.max(a,3),10);Wr(Am(l,1e3*c/Hh),`${this.head.name}.gif`),this.say("The film is saved."),this.stage.filming(!1),this.pose(r)}keys(){Im({" ":()=>this.player.toggle(),ArrowRight:()=>this.player.step(.01),ArrowLeft:()=>this.player.step(-.01),"+":()=>this.player.faster(1),"-":()=>this.player.faster(-1),g:()=>this.toggleGhosts(),v:()=>this.speedy?.click(),f:()=>this.fit(),k:()=>this.keep(),p:()=>this.present(!document.documentElement.hasAttribute("data-present")),Escape:()=>this.present(!1),Home:()=>this.player.go(-1/0),End:()=>this.player.go(1/0)}),document.addEventListener("fullscreenchange",()=>{document.fullscreenElement===null&&location.hash!=="#present"&&this.present(!1)})}keep(){this.kept=this.motion,this.comparing.value=`${Math.max(Number(this.comparing.value),1)}`,this.compare(Number(this.comparing.value))}pointer(){let e=null;this.stage.canvas.addEventListener("pointermove",t=>{if(t.buttons!==0)return;let n=this.stage.shapeAt(t.clientX,t.clientY);if(n===e)return;e=n,this.stage.highlight(n===null?[]:[n]),this.source.mark(n?.span?[n.span]:[]),this.terms.mark(n?.span??null);let s=n===null?"":this.stage.value(n,this.numbers);Xt("pointed").textContent=[n?.name??"",s].filter(r=>r!=="").join(": ")})}};function RA(){return new Promise(i=>{requestAnimationFrame(()=>setTimeout(i)),setTimeout(i,EA)})}async function PA(){let i=Cm(),e=await Promise.all(i.meshes.map(L0)),t=Pm(i,await Xr("motion")),n=new kh(i,Du(t),e,Xt("stage")),[s]=t;n.pose(s,s.state(i.start,new Float64Array(s.width)),i.start),await RA(),Rm(),await new Sf(i,t,n).begin()}PA().catch(i=>{Xt("said").textContent=`The page cannot be shown: ${String(i)}`});})();
