"use strict";(()=>{var X0="uplot",q0="u-hz",Y0="u-vt",$0="u-title",Z0="u-wrap",J0="u-under",K0="u-over",j0="u-axis",$s="u-off",Q0="u-select",t_="u-cursor-x",e_="u-cursor-y",n_="u-cursor-pt",i_="u-legend",s_="u-live",r_="u-inline",o_="u-series",a_="u-marker",vd="u-label",l_="u-value",Io="width",Lo="height";var Sd="bottom",Sr="left",zh="right",nu="#000",Md=nu+"0",kh="mousemove",bd="mousedown",Vh="mouseup",wd="mouseenter",Ed="mouseleave",Td="dblclick",c_="resize",h_="scroll",Ad="change",Ya="dppxchange",iu="--",Cr=typeof window<"u",qh=Cr?document:null,br=Cr?window:null,u_=Cr?navigator:null,Re,Ha;function Yh(){let i=devicePixelRatio;Re!=i&&(Re=i,Ha&&Zh(Ad,Ha,Yh),Ha=matchMedia(`(min-resolution: ${Re-.001}dppx) and (max-resolution: ${Re+.001}dppx)`),Zs(Ad,Ha,Yh),br.dispatchEvent(new CustomEvent(Ya)))}function ti(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function $h(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function qe(i,t,e){i.style[t]=e+"px"}function vi(i,t,e,n){let s=qh.createElement(i);return t!=null&&ti(s,t),e?.insertBefore(s,n),s}function fi(i,t){return vi("div",i,t)}var Cd=new WeakMap;function Bi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Cd.get(i);r!=o&&(i.style.transform=r,Cd.set(i,r),t<0||e<0||t>n||e>s?ti(i,$s):$h(i,$s))}var Rd=new WeakMap;function Pd(i,t,e){let n=t+e,s=Rd.get(i);n!=s&&(Rd.set(i,n),i.style.background=t,i.style.borderColor=e)}var Id=new WeakMap;function Ld(i,t,e,n){let s=t+""+e,r=Id.get(i);s!=r&&(Id.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var su={passive:!0},f_={...su,capture:!0};function Zs(i,t,e,n){t.addEventListener(i,e,n?f_:su)}function Zh(i,t,e,n){t.removeEventListener(i,e,su)}Cr&&Yh();function Si(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ei((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function op(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var ap=i=>i!=null,lp=i=>i!=null&&i>0,Ja=op(ap),d_=op(lp);function p_(i,t,e,n=0,s=!1){let r=s?d_:Ja,o=s?lp:ap;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??ke,l??-ke]}function Ka(i,t,e,n){let s=Ud(i),r=Ud(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Qi:cp,a=s==1?ei:di,l=r==1?di:ei,c=a(o(pn(i))),h=l(o(pn(t))),u=wr(e,c),f=wr(e,h);return e==10&&(c<0&&(u=Ve(u,-c)),h<0&&(f=Ve(f,-h))),n||e==2?(i=u*s,t=f*r):(i=dp(i,u),t=ja(t,f)),[i,t]}function ru(i,t,e,n){let s=Ka(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var ou=.1,Dd={mode:3,pad:ou},No={pad:0,soft:null,mode:0},m_={min:No,max:No};function $a(i,t,e,n){return Qa(e)?Nd(i,t,e):(No.pad=e,No.soft=n?0:null,No.mode=n?3:0,Nd(i,t,m_))}function Te(i,t){return i??t}function g_(i,t,e){for(t=Te(t,0),e=Te(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Nd(i,t,e){let n=e.min,s=e.max,r=Te(n.pad,0),o=Te(s.pad,0),a=Te(n.hard,-ke),l=Te(s.hard,ke),c=Te(n.soft,ke),h=Te(s.soft,-ke),u=Te(n.mode,0),f=Te(s.mode,0),d=t-i,g=Qi(d),S=zn(pn(i),pn(t)),m=Qi(S),p=pn(m-g);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=ke&&(r=0),f==2&&h!=-ke&&(o=0)));let M=d||S||1e3,C=Qi(M),v=wr(10,ei(C)),R=M*(d==0?i==0?.1:1:r),A=Ve(dp(i-R,v/10),24),y=i>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:ke,T=zn(a,A<y&&i>=y?y:Mi(y,A)),k=M*(d==0?t==0?.1:1:o),U=Ve(ja(t+k,v/10),24),L=t<=h&&(f==1||f==3&&U>=h||f==2&&U<=h)?h:-ke,V=Mi(l,U>L&&t<=L?L:zn(L,U));return T==V&&T==0&&(V=100),[T,V]}var __=new Intl.NumberFormat(Cr?u_.language:"en-US"),au=i=>__.format(i),ni=Math,qa=ni.PI,pn=ni.abs,ei=ni.floor,dn=ni.round,di=ni.ceil,Mi=ni.min,zn=ni.max,wr=ni.pow,Ud=ni.sign,Qi=ni.log10,cp=ni.log2,x_=(i,t=1)=>ni.sinh(i)*t,Gh=(i,t=1)=>ni.asinh(i/t),ke=1/0;function Fd(i){return(Qi((i^i>>31)-(i>>31))|0)+1}function Jh(i,t,e){return Mi(zn(i,t),e)}function hp(i){return typeof i=="function"}function be(i){return hp(i)?i:()=>i}var y_=()=>{},up=i=>i,fp=(i,t)=>t,v_=i=>null,Od=i=>!0,Bd=(i,t)=>i==t,S_=/\.\d*?(?=9{6,}|0{6,})/gm,Js=i=>{if(mp(i)||Ts.has(i))return i;let t=`${i}`,e=t.match(S_);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Js(s)}e${r}`}return Ve(i,n)};function qs(i,t){return Js(Ve(Js(i/t))*t)}function ja(i,t){return Js(di(Js(i/t))*t)}function dp(i,t){return Js(ei(Js(i/t))*t)}function Ve(i,t=0){if(mp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return dn(n)/e}var Ts=new Map;function pp(i){return((""+i).split(".")[1]||"").length}function Fo(i,t,e,n){let s=[],r=n.map(pp);for(let o=t;o<e;o++){let a=pn(o),l=Ve(wr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Ve(h,u);s.push(f),Ts.set(f,u)}}return s}var Uo={},lu=[],Er=[null,null],Es=Array.isArray,mp=Number.isInteger,M_=i=>i===void 0;function zd(i){return typeof i=="string"}function Qa(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function b_(i){return i!=null&&typeof i=="object"}var w_=Object.getPrototypeOf(Uint8Array),gp="__proto__";function Tr(i,t=Qa){let e;if(Es(i)){let n=i.find(s=>s!=null);if(Es(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Tr(i[s],t)}else e=i.slice()}else if(i instanceof w_)e=i.slice();else if(t(i)){e={};for(let n in i)n!=gp&&(e[n]=Tr(i[n],t))}else e=i;return e}function hn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=gp&&(Qa(i[s])?hn(i[s],Tr(n[s])):i[s]=Tr(n[s]))}return i}var E_=0,T_=1,A_=2;function C_(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function R_(i,t){if(L_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return D_(o[0])||(o=I_(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:T_,d=[];for(let g=0;g<h.length;g++){let S=h[g],m=r.get(l[g]);S===null?f!=E_&&(u[m]=S,f==A_&&d.push(m)):u[m]=S}C_(u,d,s),n.push(u)}}return n}var P_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function I_(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function L_(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function D_(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=zn(1,ei((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var _p=["January","February","March","April","May","June","July","August","September","October","November","December"],xp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function yp(i){return i.slice(0,3)}var N_=xp.map(yp),U_=_p.map(yp),F_={MMMM:_p,MMM:U_,WWWW:xp,WWW:N_};function Po(i){return(i<10?"0":"")+i}function O_(i){return(i<10?"00":i<100?"0":"")+i}var B_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Po(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Po(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Po(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Po(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Po(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>O_(i.getMilliseconds())};function cu(i,t){t=t||F_;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?B_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var z_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function k_(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==z_?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var vp=i=>i%1==0,Za=[1,2,2.5,5],V_=Fo(10,-32,0,Za),Sp=Fo(10,0,32,Za),G_=Sp.filter(vp),Ys=V_.concat(Sp),hu=`
`,Mp="{YYYY}",kd=hu+Mp,bp="{M}/{D}",Do=hu+bp,Wa=Do+"/{YY}",wp="{aa}",H_="{h}:{mm}",Mr=H_+wp,Vd=hu+Mr,Gd=":{ss}",Le=null;function Ep(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Fo(10,0,3,Za).filter(vp):Fo(10,-3,0,Za)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Mp,Le,Le,Le,Le,Le,Le,1],[s*28,"{MMM}",kd,Le,Le,Le,Le,Le,1],[s,bp,kd,Le,Le,Le,Le,Le,1],[n,"{h}"+wp,Wa,Le,Do,Le,Le,Le,1],[e,Mr,Wa,Le,Do,Le,Le,Le,1],[t,Gd,Wa+" "+Mr,Le,Do+" "+Mr,Le,Vd,Le,1],[i,Gd+".{fff}",Wa+" "+Mr,Le,Do+" "+Mr,Le,Vd,Le,1]];function h(u){return(f,d,g,S,m,p)=>{let M=[],C=m>=o,v=m>=r&&m<o,R=u(g),A=Ve(R*i,3),y=Hh(R.getFullYear(),C?0:R.getMonth(),v||C?1:R.getDate()),T=Ve(y*i,3);if(v||C){let k=v?m/r:0,U=C?m/o:0,L=A==T?A:Ve(Hh(y.getFullYear()+U,y.getMonth()+k,1)*i,3),V=new Date(dn(L/i)),X=V.getFullYear(),D=V.getMonth();for(let H=0;L<=S;H++){let q=Hh(X+U*H,D+k*H,1),G=q-u(Ve(q*i,3));L=Ve((+q+G)*i,3),L<=S&&M.push(L)}}else{let k=m>=s?s:m,U=ei(g)-ei(A),L=T+U+ja(A-T,k);M.push(L);let V=u(L),X=V.getHours()+V.getMinutes()/e+V.getSeconds()/n,D=m/n,H=f.axes[d]._space,q=p/H;for(;L=Ve(L+m,i==1?0:3),!(L>S);)if(D>1){let G=ei(Ve(X+D,6))%24,j=u(L).getHours()-G;j>1&&(j=-1),L-=j*n,X=(X+D)%24;let it=M[M.length-1];Ve((L-it)/m,3)*q>=.7&&M.push(L)}else M.push(L)}return M}}return[l,c,h]}var[W_,X_,q_]=Ep(1),[Y_,$_,Z_]=Ep(.001);Fo(2,-53,53,[1]);function Hd(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Wd(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,u,f,d;return n.map(g=>{let S=i(g),m=S.getFullYear(),p=S.getMonth(),M=S.getDate(),C=S.getHours(),v=S.getMinutes(),R=S.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||M!=h&&a[4]||C!=u&&a[5]||v!=f&&a[6]||R!=d&&a[7]||a[1];return l=m,c=p,h=M,u=C,f=v,d=R,A(S)})}}function J_(i,t){let e=cu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Hh(i,t,e){return new Date(i,t,e)}function Xd(i,t){return t(i)}var K_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function qd(i,t){return(e,n,s,r)=>r==null?iu:t(i(n))}function j_(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Q_(i,t){return i.series[t].fill(i,t)}var tx={show:!0,live:!0,isolate:!1,mount:y_,markers:{show:!0,width:2,stroke:j_,fill:Q_,dash:"solid"},idx:null,idxs:null,values:[]};function ex(i,t){let e=i.cursor.points,n=fi(),s=e.size(i,t);qe(n,Io,s),qe(n,Lo,s);let r=s/-2;qe(n,"marginLeft",r),qe(n,"marginTop",r);let o=e.width(i,t,s);return o&&qe(n,"borderWidth",o),n}function nx(i,t){let e=i.series[t].points;return e._fill||e._stroke}function ix(i,t){let e=i.series[t].points;return e._stroke||e._fill}function sx(i,t){return i.series[t].points.size}var Wh=[0,0];function rx(i,t,e){return Wh[0]=t,Wh[1]=e,Wh}function Xa(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Xh(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var ox={show:!0,x:!0,y:!0,lock:!1,move:rx,points:{one:!1,show:ex,size:sx,width:0,stroke:ix,fill:nx},bind:{mousedown:Xa,mouseup:Xa,click:Xa,dblclick:Xa,mousemove:Xh,mouseleave:Xh,mouseenter:Xh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Tp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},uu=hn({},Tp,{filter:fp}),Ap=hn({},uu,{size:10}),Cp=hn({},Tp,{show:!1}),fu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Rp="bold "+fu,Pp=1.5,Yd={show:!0,scale:"x",stroke:nu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rp,side:2,grid:uu,ticks:Ap,border:Cp,font:fu,lineGap:Pp,rotate:0},ax="Value",lx="Time",$d={show:!0,scale:"x",auto:!1,sorted:1,min:ke,max:-ke,idxs:[]};function cx(i,t,e,n,s){return t.map(r=>r==null?"":au(r))}function hx(i,t,e,n,s,r,o){let a=[],l=Ts.get(s)||0;e=o?e:Ve(ja(e,s),l);for(let c=e;c<=n;c=Ve(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Kh(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Qi:cp,h=ei(c(e));s=wr(l,h),l==10&&(s=Ys[Si(s,Ys)]);let u=e,f=s*l;l==10&&(f=Ys[Si(f,Ys)]);do a.push(u),u=u+s,l==10&&!Ts.has(u)&&(u=Ve(u,Ts.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Ys[Si(f,Ys)]));while(u<=n);return a}function ux(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Kh(i,t,zn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Kh(i,t,zn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var Ip=/./,fx=/[12357]/,dx=/[125]/,Zd=/1/,jh=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function px(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Ip:l(7,o)-h>=c?fx:l(5,o)-h>=c?dx:Zd;if(u==Zd){let f=pn(l(1,o)-h);if(f<c)return jh(t.slice().reverse(),a.distr,u,di(c/f)).reverse()}return jh(t,a.distr,u,1)}function mx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=pn(l(1,o)-l(2,o));return c<a?jh(t.slice().reverse(),3,Ip,di(a/c)).reverse():t}function gx(i,t,e,n){return n==null?iu:t==null?"":au(t)}var Jd={show:!0,scale:"y",stroke:nu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rp,side:3,grid:uu,ticks:Ap,border:Cp,font:fu,lineGap:Pp,rotate:0};function _x(i,t){let e=3+(i||1)*2;return Ve(e*t,3)}function xx(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=pn(o-r),l=i.series[t],c=a/(l.points.space*Re);return n[1]-n[0]<=c}var Kd={scale:null,auto:!0,sorted:0,min:ke,max:-ke},Lp=(i,t,e,n,s)=>s,jd={show:!0,auto:!0,sorted:0,gaps:Lp,alpha:1,facets:[hn({},Kd,{scale:"x"}),hn({},Kd,{scale:"y"})]},Qd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Lp,alpha:1,points:{show:xx,filter:null},values:null,min:ke,max:-ke,idxs:[],path:null,clip:null};function yx(i,t,e,n,s){return e/10}var Dp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},vx=hn({},Dp,{time:!1,ori:1}),tp={};function Np(i,t){let e=tp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(tp[i]=e)),e}var Ar=1,Qh=2;function Ks(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,S=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,p,f,d,g,S,el,Rr,il,Fp,Bp):e(s,l,c,h,u,p,m,d,f,S,g,nl,Pr,mu,Op,zp)}function du(i,t){let e=0,n=0,s=Te(i.bands,lu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Sx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ts(i,t,e,n,s,r){return Ks(i,t,(o,a,l,c,h,u,f,d,g,S,m)=>{let p=o.pxRound,M=c.dir*(c.ori==0?1:-1),C=c.ori==0?Rr:Pr,v,R;M==1?(v=e,R=n):(v=n,R=e);let A=p(u(a[v],c,S,d)),y=p(f(l[v],h,m,g)),T=p(u(a[R],c,S,d)),k=p(f(r==1?h.max:h.min,h,m,g)),U=new Path2D(s);return C(U,T,k),C(U,A,k),C(U,A,y),U})}function tl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?il:mu,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Mx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function pu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[u]),g=f==u?d:r(i[f]),S=u-s;d=o<=0&&S>=0&&S<l?r(i[S]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=d&&a.push([d,g])}return a}function ep(i){return i==0?up:i==1?dn:t=>qs(t,i)}function Up(i){let t=i==0?el:nl,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Mi(c,a/2,l/2),h=Mi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var el=(i,t,e)=>{i.moveTo(t,e)},nl=(i,t,e)=>{i.moveTo(e,t)},Rr=(i,t,e)=>{i.lineTo(t,e)},Pr=(i,t,e)=>{i.lineTo(e,t)},il=Up(0),mu=Up(1),Fp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Op=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Bp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},zp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function kp(i){return(t,e,n,s,r)=>Ks(t,e,(o,a,l,c,h,u,f,d,g,S,m)=>{let{pxRound:p,points:M}=o,C,v;c.ori==0?(C=el,v=Fp):(C=nl,v=Op);let R=Ve(M.width*Re,3),A=(M.size-M.width)/2*Re,y=Ve(A*2,3),T=new Path2D,k=new Path2D,{left:U,top:L,width:V,height:X}=t.bbox;il(k,U-y,L-y,V+y*2,X+y*2);let D=H=>{if(l[H]!=null){let q=p(u(a[H],c,S,d)),G=p(f(l[H],h,m,g));C(T,q+A,G),v(T,q,G,A,0,qa*2)}};if(r)r.forEach(D);else for(let H=n;H<=s;H++)D(H);return{stroke:R>0?T:null,fill:T,clip:k,flags:Ar|Qh}})}function Vp(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var bx=Vp(Rr),wx=Vp(Pr);function Gp(i){let t=Te(i?.alignGaps,0);return(e,n,s,r)=>Ks(e,n,(o,a,l,c,h,u,f,d,g,S,m)=>{[s,r]=Ja(l,s,r);let p=o.pxRound,M=X=>p(u(X,c,S,d)),C=X=>p(f(X,h,m,g)),v,R;c.ori==0?(v=Rr,R=bx):(v=Pr,R=wx);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ar},T=y.stroke,k=!1;if(r-s>=S*4){let X=ht=>e.posToVal(ht,c.key,!0),D=null,H=null,q,G,ct,Y=M(a[A==1?s:r]),j=M(a[s]),it=M(a[r]),pt=X(A==1?j+1:it-1);for(let ht=A==1?s:r;ht>=s&&ht<=r;ht+=A){let tt=a[ht],Mt=(A==1?tt<pt:tt>pt)?Y:M(tt),Lt=l[ht];Mt==Y?Lt!=null?(G=Lt,D==null?(v(T,Mt,C(G)),q=D=H=G):G<D?D=G:G>H&&(H=G)):Lt===null&&(k=!0):(D!=null&&R(T,Y,C(D),C(H),C(q),C(G)),Lt!=null?(G=Lt,v(T,Mt,C(G)),D=H=q=G):(D=H=null,Lt===null&&(k=!0)),Y=Mt,pt=X(Y+A))}D!=null&&D!=H&&ct!=Y&&R(T,Y,C(D),C(H),C(q),C(G))}else for(let X=A==1?s:r;X>=s&&X<=r;X+=A){let D=l[X];D===null?k=!0:D!=null&&v(T,M(a[X]),C(D))}let[L,V]=du(e,n);if(o.fill!=null||L!=0){let X=y.fill=new Path2D(T),D=o.fillTo(e,n,o.min,o.max,L),H=C(D),q=M(a[s]),G=M(a[r]);A==-1&&([G,q]=[q,G]),v(X,G,H),v(X,q,H)}if(!o.spanGaps){let X=[];k&&X.push(...pu(a,l,s,r,A,M,t)),y.gaps=X=o.gaps(e,n,s,r,X),y.clip=tl(X,c.ori,d,g,S,m)}return V!=0&&(y.band=V==2?[ts(e,n,s,r,T,-1),ts(e,n,s,r,T,1)]:ts(e,n,s,r,T,V)),y})}function Ex(i){let t=Te(i.align,1),e=Te(i.ascDesc,!1),n=Te(i.alignGaps,0),s=Te(i.extend,!1);return(r,o,a,l)=>Ks(r,o,(c,h,u,f,d,g,S,m,p,M,C)=>{[a,l]=Ja(u,a,l);let v=c.pxRound,{left:R,width:A}=r.bbox,y=j=>v(g(j,f,M,m)),T=j=>v(S(j,d,C,p)),k=f.ori==0?Rr:Pr,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ar},L=U.stroke,V=f.dir*(f.ori==0?1:-1),X=T(u[V==1?a:l]),D=y(h[V==1?a:l]),H=D,q=D;s&&t==-1&&(q=R,k(L,q,X)),k(L,D,X);for(let j=V==1?a:l;j>=a&&j<=l;j+=V){let it=u[j];if(it==null)continue;let pt=y(h[j]),ht=T(it);t==1?k(L,pt,X):k(L,H,ht),k(L,pt,ht),X=ht,H=pt}let G=H;s&&t==1&&(G=R+A,k(L,G,X));let[ct,Y]=du(r,o);if(c.fill!=null||ct!=0){let j=U.fill=new Path2D(L),it=c.fillTo(r,o,c.min,c.max,ct),pt=T(it);k(j,G,pt),k(j,q,pt)}if(!c.spanGaps){let j=[];j.push(...pu(h,u,a,l,V,y,n));let it=c.width*Re/2,pt=e||t==1?it:-it,ht=e||t==-1?-it:it;j.forEach(tt=>{tt[0]+=pt,tt[1]+=ht}),U.gaps=j=c.gaps(r,o,a,l,j),U.clip=tl(j,f.ori,m,p,M,C)}return Y!=0&&(U.band=Y==2?[ts(r,o,a,l,L,-1),ts(r,o,a,l,L,1)]:ts(r,o,a,l,L,Y)),U})}function np(i,t,e,n,s,r,o=ke){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=pn(i[l]-i[a]);h<c&&(c=h,o=pn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Tx(i){i=i||Uo;let t=Te(i.size,[.6,ke,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Te(t[1],ke),l=Te(t[2],1),c=Te(i.disp,Uo),h=Te(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,g,S,m)=>Ks(d,g,(p,M,C,v,R,A,y,T,k,U,L)=>{let V=p.pxRound,X=e,D=n*Re,H=a*Re,q=l*Re,G,ct;v.ori==0?[G,ct]=r(d,g):[ct,G]=r(d,g);let Y=v.dir*(v.ori==0?1:-1),j=v.ori==0?il:mu,it=v.ori==0?h:(ut,kt,Ut,yt,Xt,Et,Vt)=>{h(ut,kt,Ut,Xt,yt,Vt,Et)},pt=Te(d.bands,lu).find(ut=>ut.series[0]==g),ht=pt!=null?pt.dir:0,tt=p.fillTo(d,g,p.min,p.max,ht),gt=V(y(tt,R,L,k)),Mt,Lt,At,jt=U,he=V(p.width*Re),Zt=!1,fe=null,de=null,re=null,Ne=null;u!=null&&(he==0||f!=null)&&(Zt=!0,fe=u.values(d,g,S,m),de=new Map,new Set(fe).forEach(ut=>{ut!=null&&de.set(ut,new Path2D)}),he>0&&(re=f.values(d,g,S,m),Ne=new Map,new Set(re).forEach(ut=>{ut!=null&&Ne.set(ut,new Path2D)})));let{x0:Ie,size:Ge}=c;if(Ie!=null&&Ge!=null){X=1,M=Ie.values(d,g,S,m),Ie.unit==2&&(M=M.map(Ut=>d.posToVal(T+Ut*U,v.key,!0)));let ut=Ge.values(d,g,S,m);Ge.unit==2?Lt=ut[0]*U:Lt=A(ut[0],v,U,T)-A(0,v,U,T),jt=np(M,C,A,v,U,T,jt),At=jt-Lt+D}else jt=np(M,C,A,v,U,T,jt),At=jt*o+D,Lt=jt-At;At<1&&(At=0),he>=Lt/2&&(he=0),At<5&&(V=up);let K=At>0,ft=jt-At-(K?he:0);Lt=V(Jh(ft,q,H)),Mt=(X==0?Lt/2:X==Y?0:Lt)-X*Y*((X==0?D/2:0)+(K?he/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},bt=Zt?null:new Path2D,_t=null;if(pt!=null)_t=d.data[pt.series[1]];else{let{y0:ut,y1:kt}=c;ut!=null&&kt!=null&&(C=kt.values(d,g,S,m),_t=ut.values(d,g,S,m))}let Yt=G*Lt,P=ct*Lt;for(let ut=Y==1?S:m;ut>=S&&ut<=m;ut+=Y){let kt=C[ut];if(kt==null)continue;if(_t!=null){let B=_t[ut]??0;if(kt-B==0)continue;gt=y(B,R,L,k)}let Ut=v.distr!=2||c!=null?M[ut]:ut,yt=A(Ut,v,U,T),Xt=y(Te(kt,tt),R,L,k),Et=V(yt-Mt),Vt=V(zn(Xt,gt)),E=V(Mi(Xt,gt)),x=Vt-E;if(kt!=null){let B=kt<0?P:Yt,st=kt<0?Yt:P;Zt?(he>0&&re[ut]!=null&&j(Ne.get(re[ut]),Et,E+ei(he/2),Lt,zn(0,x-he),B,st),fe[ut]!=null&&j(de.get(fe[ut]),Et,E+ei(he/2),Lt,zn(0,x-he),B,st)):j(bt,Et,E+ei(he/2),Lt,zn(0,x-he),B,st),it(d,g,ut,Et-he/2,E,Lt+he,x)}}return he>0?xt.stroke=Zt?Ne:bt:Zt||(xt._fill=p.width==0?p._fill:p._stroke??p._fill,xt.width=0),xt.fill=Zt?de:bt,xt})}function Ax(i,t){let e=Te(t?.alignGaps,0);return(n,s,r,o)=>Ks(n,s,(a,l,c,h,u,f,d,g,S,m,p)=>{[r,o]=Ja(c,r,o);let M=a.pxRound,C=G=>M(f(G,h,m,g)),v=G=>M(d(G,u,p,S)),R,A,y;h.ori==0?(R=el,y=Rr,A=Bp):(R=nl,y=Pr,A=zp);let T=h.dir*(h.ori==0?1:-1),k=C(l[T==1?r:o]),U=k,L=[],V=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let Y=l[G],j=C(Y);L.push(U=j),V.push(v(c[G]))}let X={stroke:i(L,V,R,y,A,M),fill:null,clip:null,band:null,gaps:null,flags:Ar},D=X.stroke,[H,q]=du(n,s);if(a.fill!=null||H!=0){let G=X.fill=new Path2D(D),ct=a.fillTo(n,s,a.min,a.max,H),Y=v(ct);y(G,U,Y),y(G,k,Y)}if(!a.spanGaps){let G=[];G.push(...pu(l,c,r,o,T,C,e)),X.gaps=G=a.gaps(n,s,r,o,G),X.clip=tl(G,h.ori,g,S,m,p)}return q!=0&&(X.band=q==2?[ts(n,s,r,o,D,-1),ts(n,s,r,o,D,1)]:ts(n,s,r,o,D,q)),X})}function Cx(i){return Ax(Rx,i)}function Rx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var tu=new Set;function ip(){for(let i of tu)i.syncRect(!0)}Cr&&(Zs(c_,br,ip),Zs(h_,br,ip,!0),Zs(Ya,br,()=>{mn.pxRatio=Re}));var Px=Gp(),Ix=kp();function sp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>eu(r,o,t,e))}function Lx(i,t){return i.map((e,n)=>n==0?{}:hn({},t,e))}function eu(i,t,e,n){return hn({},t==0?e:n,i)}function Hp(i,t,e){return t==null?Er:[t,e]}var Dx=Hp;function Nx(i,t,e){return t==null?Er:$a(t,e,ou,!0)}function Wp(i,t,e,n){return t==null?Er:Ka(t,e,i.scales[n].log,!1)}var Ux=Wp;function Xp(i,t,e,n){return t==null?Er:ru(t,e,i.scales[n].log,!1)}var Fx=Xp;function Ox(i,t,e,n,s){let r=zn(Fd(i),Fd(t)),o=t-i,a=Si(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Ts.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function rp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=dn((e=+s)*Re))+"px"),[i,t,e]}function Bx(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ve(t[2]*Re,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function mn(i,t,e){let n={mode:Te(i.mode,1)},s=n.mode;function r(_,b,I,N){let W=b.valToPct(_);return N+I*(b.dir==-1?1-W:W)}function o(_,b,I,N){let W=b.valToPct(_);return N+I*(b.dir==-1?W:1-W)}function a(_,b,I,N){return b.ori==0?r(_,b,I,N):o(_,b,I,N)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=fi(X0);if(i.id!=null&&(c.id=i.id),ti(c,i.class),i.title){let _=fi($0,c);_.textContent=i.title}let h=vi("canvas"),u=n.ctx=h.getContext("2d"),f=fi(Z0,c);Zs("click",f,_=>{_.target===g&&(He!=gr||$e!=_r)&&Cn.click(n,_)},!0);let d=n.under=fi(J0,f);f.appendChild(h);let g=n.over=fi(K0,f);i=Tr(i);let S=+Te(i.pxAlign,1),m=ep(S);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,M=n.series=s==1?sp(i.series||[],$d,Qd,!1):Lx(i.series||[null],jd),C=n.axes=sp(i.axes||[],Yd,Jd,!0),v=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=be(_.fill||null),_.dir=Te(_.dir,-1)});let A=s==2?M[1].facets[0].scale:M[0].scale,y={axes:Ki,series:xe},T=(i.drawOrder||["axes","series"]).map(_=>y[_]);function k(_){let b=_.distr==3?I=>Qi(I>0?I:_.clamp(n,I,_.min,_.max,_.key)):_.distr==4?I=>Gh(I,_.asinh):_.distr==100?I=>_.fwd(I):I=>I;return I=>{let N=b(I),{_min:W,_max:J}=_,dt=J-W;return(N-W)/dt}}function U(_){let b=v[_];if(b==null){let I=(i.scales||Uo)[_]||Uo;if(I.from!=null){U(I.from);let N=hn({},v[I.from],I,{key:_});N.valToPct=k(N),v[_]=N}else{b=v[_]=hn({},_==A?Dp:vx,I),b.key=_;let N=b.time,W=b.range,J=Es(W);if((_!=A||s==2&&!N)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Dd:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Dd:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&Qa(W))){let dt=W;W=(wt,It,Gt)=>It==null?Er:$a(It,Gt,dt)}b.range=be(W||(N?Dx:_==A?b.distr==3?Ux:b.distr==4?Fx:Hp:b.distr==3?Wp:b.distr==4?Xp:Nx)),b.auto=be(J?!1:b.auto),b.clamp=be(b.clamp||yx),b._min=b._max=null,b.valToPct=k(b)}}}U("x"),U("y"),s==1&&M.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in i.scales)U(_);let L=v[A],V=L.distr,X,D;L.ori==0?(ti(c,q0),X=r,D=o):(ti(c,Y0),X=o,D=r);let H={};for(let _ in v){let b=v[_];(b.min!=null||b.max!=null)&&(H[_]={min:b.min,max:b.max},b.min=b.max=null)}let q=i.tzDate||(_=>new Date(dn(_/p))),G=i.fmtDate||cu,ct=p==1?q_(q):Z_(q),Y=Wd(q,Hd(p==1?X_:$_,G)),j=qd(q,Xd(K_,G)),it=[],pt=n.legend=hn({},tx,i.legend),ht=n.cursor=hn({},ox,{drag:{y:s==2}},i.cursor),tt=pt.show,gt=ht.show,Mt=pt.markers;pt.idxs=it,Mt.width=be(Mt.width),Mt.dash=be(Mt.dash),Mt.stroke=be(Mt.stroke),Mt.fill=be(Mt.fill);let Lt,At,jt,he=[],Zt=[],fe,de=!1,re={};if(pt.live){let _=M[1]?M[1].values:null;de=_!=null,fe=de?_(n,1,0):{_:0};for(let b in fe)re[b]=iu}if(tt)if(Lt=vi("table",i_,c),jt=vi("tbody",null,Lt),pt.mount(n,Lt),de){At=vi("thead",null,Lt,jt);let _=vi("tr",null,At);vi("th",null,_);for(var Ne in fe)vi("th",vd,_).textContent=Ne}else ti(Lt,r_),pt.live&&ti(Lt,s_);let Ie={show:!0},Ge={show:!1};function K(_,b){if(b==0&&(de||!pt.live||s==2))return Er;let I=[],N=vi("tr",o_,jt,jt.childNodes[b]);ti(N,_.class),_.show||ti(N,$s);let W=vi("th",null,N);if(Mt.show){let wt=fi(a_,W);if(b>0){let It=Mt.width(n,b);It&&(wt.style.border=It+"px "+Mt.dash(n,b)+" "+Mt.stroke(n,b)),wt.style.background=Mt.fill(n,b)}}let J=fi(vd,W);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,b>0&&(Mt.show||(J.style.color=_.width>0?Mt.stroke(n,b):Mt.fill(n,b)),xt("click",W,wt=>{if(ht._lock)return;ie(wt);let It=M.indexOf(_);if((wt.ctrlKey||wt.metaKey)!=pt.isolate){let Gt=M.some((Ht,qt)=>qt>0&&qt!=It&&Ht.show);M.forEach((Ht,qt)=>{qt>0&&Ni(qt,Gt?qt==It?Ie:Ge:Ie,!0,cn.setSeries)})}else Ni(It,{show:!_.show},!0,cn.setSeries)},!1),te&&xt(wd,W,wt=>{ht._lock||(ie(wt),Ni(M.indexOf(_),yr,!0,cn.setSeries))},!1));for(var dt in fe){let wt=vi("td",l_,N);wt.textContent="--",I.push(wt)}return[N,I]}let ft=new Map;function xt(_,b,I,N=!0){let W=ft.get(b)||{},J=ht.bind[_](n,b,I,N);J&&(Zs(_,b,W[_]=J),ft.set(b,W))}function bt(_,b,I){let N=ft.get(b)||{};for(let W in N)(_==null||W==_)&&(Zh(W,b,N[W]),delete N[W]);_==null&&ft.delete(b)}let _t=0,Yt=0,P=0,ut=0,kt=0,Ut=0,yt=kt,Xt=Ut,Et=P,Vt=ut,E=0,x=0,B=0,st=0;n.bbox={};let Q=!1,mt=!1,vt=!1,et=!1,rt=!1,St=!1;function F(_,b,I){(I||_!=n.width||b!=n.height)&&at(_,b),me(!1),vt=!0,mt=!0,Pn()}function at(_,b){n.width=_t=P=_,n.height=Yt=ut=b,kt=Ut=0,Rt(),Qt();let I=n.bbox;E=I.left=qs(kt*Re,.5),x=I.top=qs(Ut*Re,.5),B=I.width=qs(P*Re,.5),st=I.height=qs(ut*Re,.5)}let ot=3;function Pt(){let _=!1,b=0;for(;!_;){b++;let I=dr(b),N=Di(b);_=b==ot||I&&N,_||(at(n.width,n.height),mt=!0)}}function Tt({width:_,height:b}){F(_,b)}n.setSize=Tt;function Rt(){let _=!1,b=!1,I=!1,N=!1;C.forEach((W,J)=>{if(W.show&&W._show){let{side:dt,_size:wt}=W,It=dt%2,Gt=W.label!=null?W.labelSize:0,Ht=wt+Gt;Ht>0&&(It?(P-=Ht,dt==3?(kt+=Ht,N=!0):I=!0):(ut-=Ht,dt==0?(Ut+=Ht,_=!0):b=!0))}}),Ii[0]=_,Ii[1]=I,Ii[2]=b,Ii[3]=N,P-=_i[1]+_i[3],kt+=_i[3],ut-=_i[2]+_i[0],Ut+=_i[0]}function Qt(){let _=kt+P,b=Ut+ut,I=kt,N=Ut;function W(J,dt){switch(J){case 1:return _+=dt,_-dt;case 2:return b+=dt,b-dt;case 3:return I-=dt,I+dt;case 0:return N-=dt,N+dt}}C.forEach((J,dt)=>{if(J.show&&J._show){let wt=J.side;J._pos=W(wt,J._size),J.label!=null&&(J._lpos=W(wt,J.labelSize))}})}if(ht.dataIdx==null){let _=ht.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let I=_.prox=be(_.prox),N=_.bias??=0;ht.dataIdx=(W,J,dt,wt)=>{if(J==0)return dt;let It=dt,Gt=I(W,J,dt,wt)??ke,Ht=Gt>=0&&Gt<ke,qt=L.ori==0?P:ut,pe=ht.left,Ce=t[0],Ee=t[J];if(b.has(Ee[dt])){It=null;let Se=null,le=null,ne;if(N==0||N==-1)for(ne=dt;Se==null&&ne-- >0;)b.has(Ee[ne])||(Se=ne);if(N==0||N==1)for(ne=dt;le==null&&ne++<Ee.length;)b.has(Ee[ne])||(le=ne);if(Se!=null||le!=null)if(Ht){let Xe=Se==null?-1/0:X(Ce[Se],L,qt,0),tn=le==null?1/0:X(Ce[le],L,qt,0),wn=pe-Xe,ze=tn-pe;wn<=ze?wn<=Gt&&(It=Se):ze<=Gt&&(It=le)}else It=le==null?Se:Se==null?le:dt-Se<=le-dt?Se:le}else Ht&&pn(pe-X(Ce[dt],L,qt,0))>Gt&&(It=null);return It}}let ie=_=>{ht.event=_};ht.idxs=it,ht._lock=!1;let lt=ht.points;lt.show=be(lt.show),lt.size=be(lt.size),lt.stroke=be(lt.stroke),lt.width=be(lt.width),lt.fill=be(lt.fill);let Ot=n.focus=hn({},i.focus||{alpha:.3},ht.focus),te=Ot.prox>=0,Ct=te&&lt.one,ae=[],Be=[],Rn=[];function Mo(_,b){let I=lt.show(n,b);if(I instanceof HTMLElement)return ti(I,n_),ti(I,_.class),Bi(I,-10,-10,P,ut),g.insertBefore(I,ae[b]),I}function hr(_,b){if(s==1||b>0){let I=s==1&&v[_.scale].time,N=_.value;_.value=I?zd(N)?qd(q,Xd(N,G)):N||j:N||gx,_.label=_.label||(I?lx:ax)}if(Ct||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Px||v_,_.fillTo=be(_.fillTo||Sx),_.pxAlign=+Te(_.pxAlign,S),_.pxRound=ep(_.pxAlign),_.stroke=be(_.stroke||null),_.fill=be(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let I=_x(zn(1,_.width),1),N=_.points=hn({},{size:I,width:zn(1,I*.2),stroke:_.stroke,space:I*2,paths:Ix,_stroke:null,_fill:null},_.points);N.show=be(N.show),N.filter=be(N.filter),N.fill=be(N.fill),N.stroke=be(N.stroke),N.paths=be(N.paths),N.pxAlign=_.pxAlign}if(tt){let I=K(_,b);he.splice(b,0,I[0]),Zt.splice(b,0,I[1]),pt.values.push(null)}if(gt){it.splice(b,0,null);let I=null;Ct?b==0&&(I=Mo(_,b)):b>0&&(I=Mo(_,b)),ae.splice(b,0,I),Be.splice(b,0,0),Rn.splice(b,0,0)}bn("addSeries",b)}function Rh(_,b){b=b??M.length,_=s==1?eu(_,b,$d,Qd):eu(_,b,{},jd),M.splice(b,0,_),hr(M[b],b)}n.addSeries=Rh;function za(_){if(M.splice(_,1),tt){pt.values.splice(_,1),Zt.splice(_,1);let b=he.splice(_,1)[0];bt(null,b.firstChild),b.remove()}gt&&(it.splice(_,1),ae.splice(_,1)[0].remove(),Be.splice(_,1),Rn.splice(_,1)),bn("delSeries",_)}n.delSeries=za;let Ii=[!1,!1,!1,!1];function $i(_,b){if(_._show=_.show,_.show){let I=_.side%2,N=v[_.scale];N==null&&(_.scale=I?M[1].scale:A,N=v[_.scale]);let W=N.time;_.size=be(_.size),_.space=be(_.space),_.rotate=be(_.rotate),Es(_.incrs)&&_.incrs.forEach(dt=>{!Ts.has(dt)&&Ts.set(dt,pp(dt))}),_.incrs=be(_.incrs||(N.distr==2?G_:W?p==1?W_:Y_:Ys)),_.splits=be(_.splits||(W&&N.distr==1?ct:N.distr==3?Kh:N.distr==4?ux:hx)),_.stroke=be(_.stroke),_.grid.stroke=be(_.grid.stroke),_.ticks.stroke=be(_.ticks.stroke),_.border.stroke=be(_.border.stroke);let J=_.values;_.values=Es(J)&&!Es(J[0])?be(J):W?Es(J)?Wd(q,Hd(J,G)):zd(J)?J_(q,J):J||Y:J||cx,_.filter=be(_.filter||(N.distr>=3&&N.log==10?px:N.distr==3&&N.log==2?mx:fp)),_.font=rp(_.font),_.labelFont=rp(_.labelFont),_._size=_.size(n,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Ii[b]=!0,_._el=fi(j0,f))}}function Zi(_,b,I,N){let[W,J,dt,wt]=I,It=b%2,Gt=0;return It==0&&(wt||J)&&(Gt=b==0&&!W||b==2&&!dt?dn(Yd.size/3):0),It==1&&(W||dt)&&(Gt=b==1&&!J||b==3&&!wt?dn(Jd.size/2):0),Gt}let bo=n.padding=(i.padding||[Zi,Zi,Zi,Zi]).map(_=>be(Te(_,Zi))),_i=n._padding=bo.map((_,b)=>_(n,b,Ii,0)),je,nn=null,sn=null,Li=s==1?M[0].idxs:null,Jn=null,ys=!1;function wo(_,b){if(t=_??[],n.data=n._data=t,s==2){je=0;for(let I=1;I<M.length;I++)je+=t[I][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Jn=t[0],je=Jn.length;let I=t;if(V==2){I=t.slice();let N=I[0]=Array(je);for(let W=0;W<je;W++)N[W]=W}n._data=t=I}if(me(!0),bn("setData"),V==2&&(vt=!0),b!==!1){let I=L;I.auto(n,ys)?Eo():Ms(A,I.min,I.max),et=et||ht.left>=0,St=!0,Pn()}}n.setData=wo;function Eo(){ys=!0;let _,b;s==1&&(je>0?(nn=Li[0]=0,sn=Li[1]=je-1,_=t[0][nn],b=t[0][sn],V==2?(_=nn,b=sn):_==b&&(V==3?[_,b]=Ka(_,_,L.log,!1):V==4?[_,b]=ru(_,_,L.log,!1):L.time?b=_+dn(86400/p):[_,b]=$a(_,b,ou,!0))):(nn=Li[0]=_=null,sn=Li[1]=b=null)),Ms(A,_,b)}let ur,vs,fr,w,z,nt,$,Z,Dt,Ft;function Nt(_,b,I,N,W,J){_??=Md,I??=lu,N??="butt",W??=Md,J??="round",_!=ur&&(u.strokeStyle=ur=_),W!=vs&&(u.fillStyle=vs=W),b!=fr&&(u.lineWidth=fr=b),J!=z&&(u.lineJoin=z=J),N!=nt&&(u.lineCap=nt=N),I!=w&&u.setLineDash(w=I)}function Bt(_,b,I,N){b!=vs&&(u.fillStyle=vs=b),_!=$&&(u.font=$=_),I!=Z&&(u.textAlign=Z=I),N!=Dt&&(u.textBaseline=Dt=N)}function Jt(_,b,I,N,W=0){if(N.length>0&&_.auto(n,ys)&&(b==null||b.min==null)){let J=Te(nn,0),dt=Te(sn,N.length-1),wt=I.min==null?p_(N,J,dt,W,_.distr==3):[I.min,I.max];_.min=Mi(_.min,I.min=wt[0]),_.max=zn(_.max,I.max=wt[1])}}let ue={min:null,max:null};function _e(){for(let N in v){let W=v[N];H[N]==null&&(W.min==null||H[A]!=null&&W.auto(n,ys))&&(H[N]=ue)}for(let N in v){let W=v[N];H[N]==null&&W.from!=null&&H[W.from]!=null&&(H[N]=ue)}H[A]!=null&&me(!0);let _={};for(let N in H){let W=H[N];if(W!=null){let J=_[N]=Tr(v[N],b_);if(W.min!=null)hn(J,W);else if(N!=A||s==2)if(je==0&&J.from==null){let dt=J.range(n,null,null,N);J.min=dt[0],J.max=dt[1]}else J.min=ke,J.max=-ke}}if(je>0){M.forEach((N,W)=>{if(s==1){let J=N.scale,dt=H[J];if(dt==null)return;let wt=_[J];if(W==0){let It=wt.range(n,wt.min,wt.max,J);wt.min=It[0],wt.max=It[1],nn=Si(wt.min,t[0]),sn=Si(wt.max,t[0]),sn-nn>1&&(t[0][nn]<wt.min&&nn++,t[0][sn]>wt.max&&sn--),N.min=Jn[nn],N.max=Jn[sn]}else N.show&&N.auto&&Jt(wt,dt,N,t[W],N.sorted);N.idxs[0]=nn,N.idxs[1]=sn}else if(W>0&&N.show&&N.auto){let[J,dt]=N.facets,wt=J.scale,It=dt.scale,[Gt,Ht]=t[W],qt=_[wt],pe=_[It];qt!=null&&Jt(qt,H[wt],J,Gt,J.sorted),pe!=null&&Jt(pe,H[It],dt,Ht,dt.sorted),N.min=dt.min,N.max=dt.max}});for(let N in _){let W=_[N],J=H[N];if(W.from==null&&(J==null||J.min==null)){let dt=W.range(n,W.min==ke?null:W.min,W.max==-ke?null:W.max,N);W.min=dt[0],W.max=dt[1]}}}for(let N in _){let W=_[N];if(W.from!=null){let J=_[W.from];if(J.min==null)W.min=W.max=null;else{let dt=W.range(n,J.min,J.max,N);W.min=dt[0],W.max=dt[1]}}}let b={},I=!1;for(let N in _){let W=_[N],J=v[N];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let dt=J.distr;J._min=dt==3?Qi(J.min):dt==4?Gh(J.min,J.asinh):dt==100?J.fwd(J.min):J.min,J._max=dt==3?Qi(J.max):dt==4?Gh(J.max,J.asinh):dt==100?J.fwd(J.max):J.max,b[N]=I=!0}}if(I){M.forEach((N,W)=>{s==2?W>0&&b.y&&(N._paths=null):b[N.scale]&&(N._paths=null)});for(let N in b)vt=!0,bn("setScale",N);gt&&ht.left>=0&&(et=St=!0)}for(let N in H)H[N]=null}function $t(_){let b=Jh(nn-1,0,je-1),I=Jh(sn+1,0,je-1);for(;_[b]==null&&b>0;)b--;for(;_[I]==null&&I<je-1;)I++;return[b,I]}function xe(){if(je>0){let _=M.some(b=>b._focus)&&Ft!=Ot.alpha;_&&(u.globalAlpha=Ft=Ot.alpha),M.forEach((b,I)=>{if(I>0&&b.show&&(Ze(I,!1),Ze(I,!0),b._paths==null)){let N=Ft;Ft!=b.alpha&&(u.globalAlpha=Ft=b.alpha);let W=s==2?[0,t[I][0].length-1]:$t(t[I]);b._paths=b.paths(n,I,W[0],W[1]),Ft!=N&&(u.globalAlpha=Ft=N)}}),M.forEach((b,I)=>{if(I>0&&b.show){let N=Ft;Ft!=b.alpha&&(u.globalAlpha=Ft=b.alpha),b._paths!=null&&Ue(I,!1);{let W=b._paths!=null?b._paths.gaps:null,J=b.points.show(n,I,nn,sn,W),dt=b.points.filter(n,I,J,W);(J||dt)&&(b.points._paths=b.points.paths(n,I,nn,sn,dt),Ue(I,!0))}Ft!=N&&(u.globalAlpha=Ft=N),bn("drawSeries",I)}}),_&&(u.globalAlpha=Ft=1)}}function Ze(_,b){let I=b?M[_].points:M[_];I._stroke=I.stroke(n,_),I._fill=I.fill(n,_)}function Ue(_,b){let I=b?M[_].points:M[_],{stroke:N,fill:W,clip:J,flags:dt,_stroke:wt=I._stroke,_fill:It=I._fill,_width:Gt=I.width}=I._paths;Gt=Ve(Gt*Re,3);let Ht=null,qt=Gt%2/2;b&&It==null&&(It=Gt>0?"#fff":wt);let pe=I.pxAlign==1&&qt>0;if(pe&&u.translate(qt,qt),!b){let Ce=E-Gt/2,Ee=x-Gt/2,Se=B+Gt,le=st+Gt;Ht=new Path2D,Ht.rect(Ce,Ee,Se,le)}b?Wt(wt,Gt,I.dash,I.cap,It,N,W,dt,J):Fe(_,wt,Gt,I.dash,I.cap,It,N,W,dt,Ht,J),pe&&u.translate(-qt,-qt)}function Fe(_,b,I,N,W,J,dt,wt,It,Gt,Ht){let qt=!1;It!=0&&R.forEach((pe,Ce)=>{if(pe.series[0]==_){let Ee=M[pe.series[1]],Se=t[pe.series[1]],le=(Ee._paths||Uo).band;Es(le)&&(le=pe.dir==1?le[0]:le[1]);let ne,Xe=null;Ee.show&&le&&g_(Se,nn,sn)?(Xe=pe.fill(n,Ce)||J,ne=Ee._paths.clip):le=null,Wt(b,I,N,W,Xe,dt,wt,It,Gt,Ht,ne,le),qt=!0}}),qt||Wt(b,I,N,W,J,dt,wt,It,Gt,Ht)}let fn=Ar|Qh;function Wt(_,b,I,N,W,J,dt,wt,It,Gt,Ht,qt){Nt(_,b,I,N,W),(It||Gt||qt)&&(u.save(),It&&u.clip(It),Gt&&u.clip(Gt)),qt?(wt&fn)==fn?(u.clip(qt),Ht&&u.clip(Ht),Me(W,dt),on(_,J,b)):wt&Qh?(Me(W,dt),u.clip(qt),on(_,J,b)):wt&Ar&&(u.save(),u.clip(qt),Ht&&u.clip(Ht),Me(W,dt),u.restore(),on(_,J,b)):(Me(W,dt),on(_,J,b)),(It||Gt||qt)&&u.restore()}function on(_,b,I){I>0&&(b instanceof Map?b.forEach((N,W)=>{u.strokeStyle=ur=W,u.stroke(N)}):b!=null&&_&&u.stroke(b))}function Me(_,b){b instanceof Map?b.forEach((I,N)=>{u.fillStyle=vs=N,u.fill(I)}):b!=null&&_&&u.fill(b)}function Ji(_,b,I,N){let W=C[_],J;if(N<=0)J=[0,0];else{let dt=W._space=W.space(n,_,b,I,N),wt=W._incrs=W.incrs(n,_,b,I,N,dt);J=Ox(b,I,wt,N,dt)}return W._found=J}function an(_,b,I,N,W,J,dt,wt,It,Gt){let Ht=dt%2/2;S==1&&u.translate(Ht,Ht),Nt(wt,dt,It,Gt,wt),u.beginPath();let qt,pe,Ce,Ee,Se=W+(N==0||N==3?-J:J);I==0?(pe=W,Ee=Se):(qt=W,Ce=Se);for(let le=0;le<_.length;le++)b[le]!=null&&(I==0?qt=Ce=_[le]:pe=Ee=_[le],u.moveTo(qt,pe),u.lineTo(Ce,Ee));u.stroke(),S==1&&u.translate(-Ht,-Ht)}function dr(_){let b=!0;return C.forEach((I,N)=>{if(!I.show)return;let W=v[I.scale];if(W.min==null){I._show&&(b=!1,I._show=!1,me(!1));return}else I._show||(b=!1,I._show=!0,me(!1));let J=I.side,dt=J%2,{min:wt,max:It}=W,[Gt,Ht]=Ji(N,wt,It,dt==0?P:ut);if(Ht==0)return;let qt=W.distr==2,pe=I._splits=I.splits(n,N,wt,It,Gt,Ht,qt),Ce=W.distr==2?pe.map(ne=>Jn[ne]):pe,Ee=W.distr==2?Jn[pe[1]]-Jn[pe[0]]:Gt,Se=I._values=I.values(n,I.filter(n,Ce,N,Ht,Ee),N,Ht,Ee);I._rotate=J==2?I.rotate(n,Se,N,Ht):0;let le=I._size;I._size=di(I.size(n,Se,N,_)),le!=null&&I._size!=le&&(b=!1)}),b}function Di(_){let b=!0;return bo.forEach((I,N)=>{let W=I(n,N,Ii,_);W!=_i[N]&&(b=!1),_i[N]=W}),b}function Ki(){for(let _=0;_<C.length;_++){let b=C[_];if(!b.show||!b._show)continue;let I=b.side,N=I%2,W,J,dt=b.stroke(n,_),wt=I==0||I==3?-1:1,[It,Gt]=b._found;if(b.label!=null){let On=b.labelGap*wt,Qn=dn((b._lpos+On)*Re);Bt(b.labelFont[0],dt,"center",I==2?"top":Sd),u.save(),N==1?(W=J=0,u.translate(Qn,dn(x+st/2)),u.rotate((I==3?-qa:qa)/2)):(W=dn(E+B/2),J=Qn);let Xs=hp(b.label)?b.label(n,_,It,Gt):b.label;u.fillText(Xs,W,J),u.restore()}if(Gt==0)continue;let Ht=v[b.scale],qt=N==0?B:st,pe=N==0?E:x,Ce=b._splits,Ee=Ht.distr==2?Ce.map(On=>Jn[On]):Ce,Se=Ht.distr==2?Jn[Ce[1]]-Jn[Ce[0]]:It,le=b.ticks,ne=b.border,Xe=le.show?le.size:0,tn=dn(Xe*Re),wn=dn((b.alignTo==2?b._size-Xe-b.gap:b.gap)*Re),ze=b._rotate*-qa/180,en=m(b._pos*Re),Kn=(tn+wn)*wt,Fn=en+Kn;J=N==0?Fn:0,W=N==1?Fn:0;let hi=b.font[0],xi=b.align==1?Sr:b.align==2?zh:ze>0?Sr:ze<0?zh:N==0?"center":I==3?zh:Sr,Fi=ze||N==1?"middle":I==2?"top":Sd;Bt(hi,dt,xi,Fi);let jn=b.font[1]*b.lineGap,ui=Ce.map(On=>m(a(On,Ht,qt,pe))),yi=b._values;for(let On=0;On<yi.length;On++){let Qn=yi[On];if(Qn!=null){N==0?W=ui[On]:J=ui[On],Qn=""+Qn;let Xs=Qn.indexOf(`
`)==-1?[Qn]:Qn.split(/\n/gm);for(let Bn=0;Bn<Xs.length;Bn++){let yd=Xs[Bn];ze?(u.save(),u.translate(W,J+Bn*jn),u.rotate(ze),u.fillText(yd,0,0),u.restore()):u.fillText(yd,W,J+Bn*jn)}}}le.show&&an(ui,le.filter(n,Ee,_,Gt,Se),N,I,en,tn,Ve(le.width*Re,3),le.stroke(n,_),le.dash,le.cap);let Oi=b.grid;Oi.show&&an(ui,Oi.filter(n,Ee,_,Gt,Se),N,N==0?2:1,N==0?x:E,N==0?st:B,Ve(Oi.width*Re,3),Oi.stroke(n,_),Oi.dash,Oi.cap),ne.show&&an([en],[1],N==0?1:0,N==0?1:2,N==1?x:E,N==1?st:B,Ve(ne.width*Re,3),ne.stroke(n,_),ne.dash,ne.cap)}bn("drawAxes")}function me(_){M.forEach((b,I)=>{I>0&&(b._paths=null,_&&(s==1?(b.min=null,b.max=null):b.facets.forEach(N=>{N.min=null,N.max=null})))})}let Qe=!1,Un=!1,Oe=[];function ln(){Un=!1;for(let _=0;_<Oe.length;_++)bn(...Oe[_]);Oe.length=0}function Pn(){Qe||(P_(ed),Qe=!0)}function ka(_,b=!1){Qe=!0,Un=b,_(n),ed(),b&&Oe.length>0&&queueMicrotask(ln)}n.batch=ka;function ed(){if(Q&&(_e(),Q=!1),vt&&(Pt(),vt=!1),mt){if(qe(d,Sr,kt),qe(d,"top",Ut),qe(d,Io,P),qe(d,Lo,ut),qe(g,Sr,kt),qe(g,"top",Ut),qe(g,Io,P),qe(g,Lo,ut),qe(f,Io,_t),qe(f,Lo,Yt),h.width=dn(_t*Re),h.height=dn(Yt*Re),C.forEach(({_el:_,_show:b,_size:I,_pos:N,side:W})=>{if(_!=null)if(b){let J=W===3||W===0?I:0,dt=W%2==1;qe(_,dt?"left":"top",N-J),qe(_,dt?"width":"height",I),qe(_,dt?"top":"left",dt?Ut:kt),qe(_,dt?"height":"width",dt?ut:P),$h(_,$s)}else ti(_,$s)}),ur=vs=fr=z=nt=$=Z=Dt=w=null,Ft=1,Co(!0),kt!=yt||Ut!=Xt||P!=Et||ut!=Vt){me(!1);let _=P/Et,b=ut/Vt;if(gt&&!et&&ht.left>=0){ht.left*=_,ht.top*=b,pr&&Bi(pr,dn(ht.left),0,P,ut),mr&&Bi(mr,0,dn(ht.top),P,ut);for(let I=0;I<ae.length;I++){let N=ae[I];N!=null&&(Be[I]*=_,Rn[I]*=b,Bi(N,di(Be[I]),di(Rn[I]),P,ut))}}if(We.show&&!rt&&We.left>=0&&We.width>0){We.left*=_,We.width*=_,We.top*=b,We.height*=b;for(let I in Uh)qe(xr,I,We[I])}yt=kt,Xt=Ut,Et=P,Vt=ut}bn("setSize"),mt=!1}_t>0&&Yt>0&&(u.clearRect(0,0,h.width,h.height),bn("drawClear"),T.forEach(_=>_()),bn("draw")),We.show&&rt&&(Va(We),rt=!1),gt&&et&&(Ws(null,!0,!1),et=!1),pt.show&&pt.live&&St&&(Dh(),St=!1),l||(l=!0,n.status=1,bn("ready")),ys=!1,Qe=!1}n.redraw=(_,b)=>{vt=b||!1,_!==!1?Ms(A,L.min,L.max):Pn()};function Ph(_,b){let I=v[_];if(I.from==null){if(je==0){let N=I.range(n,b.min,b.max,_);b.min=N[0],b.max=N[1]}if(b.min>b.max){let N=b.min;b.min=b.max,b.max=N}if(je>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==A&&I.distr==2&&je>0&&(b.min=Si(b.min,t[0]),b.max=Si(b.max,t[0]),b.min==b.max&&b.max++),H[_]=b,Q=!0,Pn()}}n.setScale=Ph;let Ih,Lh,pr,mr,nd,id,gr,_r,sd,rd,He,$e,Ss=!1,Cn=ht.drag,Sn=Cn.x,Mn=Cn.y;gt&&(ht.x&&(Ih=fi(t_,g)),ht.y&&(Lh=fi(e_,g)),L.ori==0?(pr=Ih,mr=Lh):(pr=Lh,mr=Ih),He=ht.left,$e=ht.top);let We=n.select=hn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),xr=We.show?fi(Q0,We.over?g:d):null;function Va(_,b){if(We.show){for(let I in _)We[I]=_[I],I in Uh&&qe(xr,I,_[I]);b!==!1&&bn("setSelect")}}n.setSelect=Va;function D0(_){if(M[_].show)tt&&$h(he[_],$s);else if(tt&&ti(he[_],$s),gt){let I=Ct?ae[0]:ae[_];I!=null&&Bi(I,-10,-10,P,ut)}}function Ms(_,b,I){Ph(_,{min:b,max:I})}function Ni(_,b,I,N){b.focus!=null&&B0(_),b.show!=null&&M.forEach((W,J)=>{J>0&&(_==J||_==null)&&(W.show=b.show,D0(J),s==2?(Ms(W.facets[0].scale,null,null),Ms(W.facets[1].scale,null,null)):Ms(W.scale,null,null),Pn())}),I!==!1&&bn("setSeries",_,b),N&&Ro("setSeries",n,_,b)}n.setSeries=Ni;function N0(_,b){hn(R[_],b)}function U0(_,b){_.fill=be(_.fill||null),_.dir=Te(_.dir,-1),b=b??R.length,R.splice(b,0,_)}function F0(_){_==null?R.length=0:R.splice(_,1)}n.addBand=U0,n.setBand=N0,n.delBand=F0;function O0(_,b){M[_].alpha=b,gt&&ae[_]!=null&&(ae[_].style.opacity=b),tt&&he[_]&&(he[_].style.opacity=b)}let ji,bs,Hs,yr={focus:!0};function B0(_){if(_!=Hs){let b=_==null,I=Ot.alpha!=1;M.forEach((N,W)=>{if(s==1||W>0){let J=b||W==0||W==_;N._focus=b?null:J,I&&O0(W,J?1:Ot.alpha)}}),Hs=_,I&&Pn()}}tt&&te&&xt(Ed,Lt,_=>{ht._lock||(ie(_),Hs!=null&&Ni(null,yr,!0,cn.setSeries))});function Ui(_,b,I){let N=v[b];I&&(_=_/Re-(N.ori==1?Ut:kt));let W=P;N.ori==1&&(W=ut,_=W-_),N.dir==-1&&(_=W-_);let J=N._min,dt=N._max,wt=_/W,It=J+(dt-J)*wt,Gt=N.distr;return Gt==3?wr(10,It):Gt==4?x_(It,N.asinh):Gt==100?N.bwd(It):It}function z0(_,b){let I=Ui(_,A,b);return Si(I,t[0],nn,sn)}n.valToIdx=_=>Si(_,t[0]),n.posToIdx=z0,n.posToVal=Ui,n.valToPos=(_,b,I)=>v[b].ori==0?r(_,v[b],I?B:P,I?E:0):o(_,v[b],I?st:ut,I?x:0),n.setCursor=(_,b,I)=>{He=_.left,$e=_.top,Ws(null,b,I)};function od(_,b){qe(xr,Sr,We.left=_),qe(xr,Io,We.width=b)}function ad(_,b){qe(xr,"top",We.top=_),qe(xr,Lo,We.height=b)}let To=L.ori==0?od:ad,Ao=L.ori==1?od:ad;function k0(){if(tt&&pt.live)for(let _=s==2?1:0;_<M.length;_++){if(_==0&&de)continue;let b=pt.values[_],I=0;for(let N in b)Zt[_][I++].firstChild.nodeValue=b[N]}}function Dh(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((I,N)=>{it[N]=I}):M_(_.idx)||it.fill(_.idx),pt.idx=it[0]),tt&&pt.live){for(let I=0;I<M.length;I++)(I>0||s==1&&!de)&&V0(I,it[I]);k0()}St=!1,b!==!1&&bn("setLegend")}n.setLegend=Dh;function V0(_,b){let I=M[_],N=_==0&&V==2?Jn:t[_],W;de?W=I.values(n,_,b)??re:(W=I.value(n,b==null?null:N[b],_,b),W=W==null?re:{_:W}),pt.values[_]=W}function Ws(_,b,I){sd=He,rd=$e,[He,$e]=ht.move(n,He,$e),ht.left=He,ht.top=$e,gt&&(pr&&Bi(pr,dn(He),0,P,ut),mr&&Bi(mr,0,dn($e),P,ut));let N,W=nn>sn;ji=ke,bs=null;let J=L.ori==0?P:ut,dt=L.ori==1?P:ut;if(He<0||je==0||W){N=ht.idx=null;for(let wt=0;wt<M.length;wt++){let It=ae[wt];It!=null&&Bi(It,-10,-10,P,ut)}te&&Ni(null,yr,!0,_==null&&cn.setSeries),pt.live&&(it.fill(N),St=!0)}else{let wt,It,Gt;s==1&&(wt=L.ori==0?He:$e,It=Ui(wt,A),N=ht.idx=Si(It,t[0],nn,sn),Gt=X(t[0][N],L,J,0));let Ht=-10,qt=-10,pe=0,Ce=0,Ee=!0,Se="",le="";for(let ne=s==2?1:0;ne<M.length;ne++){let Xe=M[ne],tn=it[ne],wn=tn==null?null:s==1?t[ne][tn]:t[ne][1][tn],ze=ht.dataIdx(n,ne,N,It),en=ze==null?null:s==1?t[ne][ze]:t[ne][1][ze];if(St=St||en!=wn||ze!=tn,it[ne]=ze,ne>0&&Xe.show){let Kn=ze==null?-10:ze==N?Gt:X(s==1?t[0][ze]:t[ne][0][ze],L,J,0),Fn=en==null?-10:D(en,s==1?v[Xe.scale]:v[Xe.facets[1].scale],dt,0);if(te&&en!=null){let hi=L.ori==1?He:$e,xi=pn(Ot.dist(n,ne,ze,Fn,hi));if(xi<ji){let Fi=Ot.bias;if(Fi!=0){let jn=Ui(hi,Xe.scale),ui=en>=0?1:-1,yi=jn>=0?1:-1;yi==ui&&(yi==1?Fi==1?en>=jn:en<=jn:Fi==1?en<=jn:en>=jn)&&(ji=xi,bs=ne)}else ji=xi,bs=ne}}if(St||Ct){let hi,xi;L.ori==0?(hi=Kn,xi=Fn):(hi=Fn,xi=Kn);let Fi,jn,ui,yi,Oi,On,Qn=!0,Xs=lt.bbox;if(Xs!=null){Qn=!1;let Bn=Xs(n,ne);ui=Bn.left,yi=Bn.top,Fi=Bn.width,jn=Bn.height}else ui=hi,yi=xi,Fi=jn=lt.size(n,ne);if(On=lt.fill(n,ne),Oi=lt.stroke(n,ne),Ct)ne==bs&&ji<=Ot.prox&&(Ht=ui,qt=yi,pe=Fi,Ce=jn,Ee=Qn,Se=On,le=Oi);else{let Bn=ae[ne];Bn!=null&&(Be[ne]=ui,Rn[ne]=yi,Ld(Bn,Fi,jn,Qn),Pd(Bn,On,Oi),Bi(Bn,di(ui),di(yi),P,ut))}}}}if(Ct){let ne=Ot.prox,Xe=Hs==null?ji<=ne:ji>ne||bs!=Hs;if(St||Xe){let tn=ae[0];tn!=null&&(Be[0]=Ht,Rn[0]=qt,Ld(tn,pe,Ce,Ee),Pd(tn,Se,le),Bi(tn,di(Ht),di(qt),P,ut))}}}if(We.show&&Ss)if(_!=null){let[wt,It]=cn.scales,[Gt,Ht]=cn.match,[qt,pe]=_.cursor.sync.scales,Ce=_.cursor.drag;if(Sn=Ce._x,Mn=Ce._y,Sn||Mn){let{left:Ee,top:Se,width:le,height:ne}=_.select,Xe=_.scales[qt].ori,tn=_.posToVal,wn,ze,en,Kn,Fn,hi=wt!=null&&Gt(wt,qt),xi=It!=null&&Ht(It,pe);hi&&Sn?(Xe==0?(wn=Ee,ze=le):(wn=Se,ze=ne),en=v[wt],Kn=X(tn(wn,qt),en,J,0),Fn=X(tn(wn+ze,qt),en,J,0),To(Mi(Kn,Fn),pn(Fn-Kn))):To(0,J),xi&&Mn?(Xe==1?(wn=Ee,ze=le):(wn=Se,ze=ne),en=v[It],Kn=D(tn(wn,pe),en,dt,0),Fn=D(tn(wn+ze,pe),en,dt,0),Ao(Mi(Kn,Fn),pn(Fn-Kn))):Ao(0,dt)}else Fh()}else{let wt=pn(sd-nd),It=pn(rd-id);if(L.ori==1){let pe=wt;wt=It,It=pe}Sn=Cn.x&&wt>=Cn.dist,Mn=Cn.y&&It>=Cn.dist;let Gt=Cn.uni;Gt!=null?Sn&&Mn&&(Sn=wt>=Gt,Mn=It>=Gt,!Sn&&!Mn&&(It>wt?Mn=!0:Sn=!0)):Cn.x&&Cn.y&&(Sn||Mn)&&(Sn=Mn=!0);let Ht,qt;Sn&&(L.ori==0?(Ht=gr,qt=He):(Ht=_r,qt=$e),To(Mi(Ht,qt),pn(qt-Ht)),Mn||Ao(0,dt)),Mn&&(L.ori==1?(Ht=gr,qt=He):(Ht=_r,qt=$e),Ao(Mi(Ht,qt),pn(qt-Ht)),Sn||To(0,J)),!Sn&&!Mn&&(To(0,0),Ao(0,0))}if(Cn._x=Sn,Cn._y=Mn,_==null){if(I){if(xd!=null){let[wt,It]=cn.scales;cn.values[0]=wt!=null?Ui(L.ori==0?He:$e,wt):null,cn.values[1]=It!=null?Ui(L.ori==1?He:$e,It):null}Ro(kh,n,He,$e,P,ut,N)}if(te){let wt=I&&cn.setSeries,It=Ot.prox;Hs==null?ji<=It&&Ni(bs,yr,!0,wt):ji>It?Ni(null,yr,!0,wt):bs!=Hs&&Ni(bs,yr,!0,wt)}}St&&(pt.idx=N,Dh()),b!==!1&&bn("setCursor")}let ws=null;Object.defineProperty(n,"rect",{get(){return ws==null&&Co(!1),ws}});function Co(_=!1){_?ws=null:(ws=g.getBoundingClientRect(),bn("syncRect",ws))}function ld(_,b,I,N,W,J,dt){ht._lock||Ss&&_!=null&&_.movementX==0&&_.movementY==0||(Nh(_,b,I,N,W,J,dt,!1,_!=null),_!=null?Ws(null,!0,!0):Ws(b,!0,!1))}function Nh(_,b,I,N,W,J,dt,wt,It){if(ws==null&&Co(!1),ie(_),_!=null)I=_.clientX-ws.left,N=_.clientY-ws.top;else{if(I<0||N<0){He=-10,$e=-10;return}let[Gt,Ht]=cn.scales,qt=b.cursor.sync,[pe,Ce]=qt.values,[Ee,Se]=qt.scales,[le,ne]=cn.match,Xe=b.axes[0].side%2==1,tn=L.ori==0?P:ut,wn=L.ori==1?P:ut,ze=Xe?J:W,en=Xe?W:J,Kn=Xe?N:I,Fn=Xe?I:N;if(Ee!=null?I=le(Gt,Ee)?a(pe,v[Gt],tn,0):-10:I=tn*(Kn/ze),Se!=null?N=ne(Ht,Se)?a(Ce,v[Ht],wn,0):-10:N=wn*(Fn/en),L.ori==1){let hi=I;I=N,N=hi}}It&&(b==null||b.cursor.event.type==kh)&&((I<=1||I>=P-1)&&(I=qs(I,P)),(N<=1||N>=ut-1)&&(N=qs(N,ut))),wt?(nd=I,id=N,[gr,_r]=ht.move(n,I,N)):(He=I,$e=N)}let Uh={width:0,height:0,left:0,top:0};function Fh(){Va(Uh,!1)}let cd,hd,ud,fd;function dd(_,b,I,N,W,J,dt){Ss=!0,Sn=Mn=Cn._x=Cn._y=!1,Nh(_,b,I,N,W,J,dt,!0,!1),_!=null&&(xt(Vh,qh,pd,!1),Ro(bd,n,gr,_r,P,ut,null));let{left:wt,top:It,width:Gt,height:Ht}=We;cd=wt,hd=It,ud=Gt,fd=Ht}function pd(_,b,I,N,W,J,dt){Ss=Cn._x=Cn._y=!1,Nh(_,b,I,N,W,J,dt,!1,!0);let{left:wt,top:It,width:Gt,height:Ht}=We,qt=Gt>0||Ht>0,pe=cd!=wt||hd!=It||ud!=Gt||fd!=Ht;if(qt&&pe&&Va(We),Cn.setScale&&qt&&pe){let Ce=wt,Ee=Gt,Se=It,le=Ht;if(L.ori==1&&(Ce=It,Ee=Ht,Se=wt,le=Gt),Sn&&Ms(A,Ui(Ce,A),Ui(Ce+Ee,A)),Mn)for(let ne in v){let Xe=v[ne];ne!=A&&Xe.from==null&&Xe.min!=ke&&Ms(ne,Ui(Se+le,ne),Ui(Se,ne))}Fh()}else ht.lock&&(ht._lock=!ht._lock,Ws(b,!0,_!=null));_!=null&&(bt(Vh,qh),Ro(Vh,n,He,$e,P,ut,null))}function G0(_,b,I,N,W,J,dt){if(ht._lock)return;ie(_);let wt=Ss;if(Ss){let It=!0,Gt=!0,Ht=10,qt,pe;L.ori==0?(qt=Sn,pe=Mn):(qt=Mn,pe=Sn),qt&&pe&&(It=He<=Ht||He>=P-Ht,Gt=$e<=Ht||$e>=ut-Ht),qt&&It&&(He=He<gr?0:P),pe&&Gt&&($e=$e<_r?0:ut),Ws(null,!0,!0),Ss=!1}He=-10,$e=-10,it.fill(null),Ws(null,!0,!0),wt&&(Ss=wt)}function md(_,b,I,N,W,J,dt){ht._lock||(ie(_),Eo(),Fh(),_!=null&&Ro(Td,n,He,$e,P,ut,null))}function gd(){C.forEach(Bx),F(n.width,n.height,!0)}Zs(Ya,br,gd);let vr={};vr.mousedown=dd,vr.mousemove=ld,vr.mouseup=pd,vr.dblclick=md,vr.setSeries=(_,b,I,N)=>{let W=cn.match[2];I=W(n,b,I),I!=-1&&Ni(I,N,!0,!1)},gt&&(xt(bd,g,dd),xt(kh,g,ld),xt(wd,g,_=>{ie(_),Co(!1)}),xt(Ed,g,G0),xt(Td,g,md),tu.add(n),n.syncRect=Co);let Ga=n.hooks=i.hooks||{};function bn(_,b,I){Un?Oe.push([_,b,I]):_ in Ga&&Ga[_].forEach(N=>{N.call(null,n,b,I)})}(i.plugins||[]).forEach(_=>{for(let b in _.hooks)Ga[b]=(Ga[b]||[]).concat(_.hooks[b])});let _d=(_,b,I)=>I,cn=hn({key:null,setSeries:!1,filters:{pub:Od,sub:Od},scales:[A,M[1]?M[1].scale:null],match:[Bd,Bd,_d],values:[null,null]},ht.sync);cn.match.length==2&&cn.match.push(_d),ht.sync=cn;let xd=cn.key,Oh=Np(xd);function Ro(_,b,I,N,W,J,dt){cn.filters.pub(_,b,I,N,W,J,dt)&&Oh.pub(_,b,I,N,W,J,dt)}Oh.sub(n);function H0(_,b,I,N,W,J,dt){cn.filters.sub(_,b,I,N,W,J,dt)&&vr[_](null,b,I,N,W,J,dt)}n.pub=H0;function W0(){Oh.unsub(n),tu.delete(n),ft.clear(),Zh(Ya,br,gd),c.remove(),Lt?.remove(),bn("destroy")}n.destroy=W0;function Bh(){bn("init",i,t),wo(t||i.data,!1),H[A]?Ph(A,H[A]):Eo(),rt=We.show&&(We.width>0||We.height>0),et=St=!0,F(i.width,i.height)}return M.forEach(hr),C.forEach($i),e?e instanceof HTMLElement?(e.appendChild(c),Bh()):e(n,Bh):Bh(),n}mn.assign=hn;mn.fmtNum=au;mn.rangeNum=$a;mn.rangeLog=Ka;mn.rangeAsinh=ru;mn.orient=Ks;mn.pxRatio=Re;mn.join=R_;mn.fmtDate=cu,mn.tzDate=k_;mn.sync=Np;{mn.addGap=Mx,mn.clipGaps=tl;let i=mn.paths={points:kp};i.linear=Gp,i.stepped=Ex,i.bars=Tx,i.spline=Cx}function Ir(i,t){if(!Number.isFinite(i))return"\u2013";let e=Number(i.toPrecision(t)),n=Math.abs(e);return n!==0&&(n>=1e6||n<1e-4)?qp(e.toExponential()):`${e}`}function qp(i){return i.replace("e+","e")}function Yp(i,t){let e=Math.max(...i.map(Math.abs));if(e>=1e6||t<1e-4){let r=Math.max(Math.ceil(Math.log10(e/t)-1e-9),0);return i.map(o=>o===0?"0":qp(o.toExponential(Math.min(r,15)).replace(/\.?0+e/,"e")))}let n=0;for(;Math.abs(t*10**n-Math.round(t*10**n))>1e-6;)++n;let s={minimumFractionDigits:n,maximumFractionDigits:n};return i.map(r=>(r===0?0:r).toLocaleString("en-US",s))}function Lr(i){let t=10**Math.floor(Math.log10(i));return([1,2,5].find(e=>e*t>=i*(1-1e-9))??10)*t}function sl(i,t,e){let s=new Map;for(let r of i){let o=Math.floor(400*(r.time-t)/(e-t||1));(s.get(o)?.kind??"tick")==="tick"&&s.set(o,r)}return[...s.values()]}var Oo=["#2563eb","#dc2626","#16a34a","#d97706","#7c3aed","#0891b2","#db2777","#65a30d"],rl=600;function Bo(i){let t=getComputedStyle(document.documentElement),e=t.getPropertyValue("--ink-soft").trim(),n={stroke:t.getPropertyValue("--line").trim(),width:1};return{label:i,stroke:e,grid:n,ticks:n,labelSize:18,font:"11px system-ui",labelFont:"11px system-ui",values:(s,r,o,a,l)=>Yp(r,l)}}function ol(i){let t=(e,n)=>Math.max(64,36+6.5*Math.max(0,...(n??[]).map(s=>s.length)));return{...Bo(i),size:t}}var zx=20,al=class{constructor(t,e,n){this.head=t;this.motion=e;let s=t.columns.slice(0,t.scene.first),r=s.filter(c=>c.kind==="coordinate").length,o=r>0?1:Math.min(1,s.length-1),a=r>0?1+r:s.length-1;if(this.choices=[this.choice("right",s,o),this.choice("up",s,a)],this.dot.className="dot",s.length<2)return;let l=document.createElement("p");l.className="portrait",l.append(this.choices[1]," over ",this.choices[0]),n.append(l,this.board),this.rebuild()}head;motion;plot=null;board=document.createElement("div");dot=document.createElement("i");choices;choice(t,e,n){let s=document.createElement("select");return s.setAttribute("aria-label",`Column of the portrait, to the ${t}`.replace("to the up","upward")),e.forEach(({name:r},o)=>s.append(new Option(r,`${o}`,o===n,o===n))),s.onchange=()=>this.rebuild(),s}values(t){let e=Number(this.choices[t].value),{scale:n,shift:s}=this.head.columns[e].display;return this.motion.column(e).map(r=>r*n+s)}get data(){return[null,[this.values(0),this.values(1)]]}rebuild(){this.plot?.destroy();let[t,e]=this.choices.map(s=>{let{name:r,display:o}=this.head.columns[Number(s.value)],a=`[${o.unit||"1"}]`;return r.length<=zx?`${r} ${a}`:a}),n=s=>()=>{let[r,o]=[1/0,-1/0];for(let c of this.values(s))Number.isFinite(c)&&([r,o]=[Math.min(r,c),Math.max(o,c)]);o>r||([r,o]=[(Number.isFinite(r)?r:0)-1,(Number.isFinite(o)?o:0)+1]);let a=Math.max(Math.abs(r),Math.abs(o)),l=Math.max(.06*(o-r),o-r<1e-6*a?.001*a:0,1e-12);return[r-l,o+l]};this.plot=new mn({...this.size(),mode:2,scales:{x:{time:!1,range:n(0)},y:{range:n(1)}},axes:[{...Bo(t),size:40},ol(e)],cursor:{show:!1},legend:{show:!1},series:[{},{facets:[{scale:"x",auto:!0},{scale:"y",auto:!0}],paths:kx}]},this.data,this.board),this.plot.over.append(this.dot)}show(t){this.motion=t,this.plot?.setData(this.data)}point(t){if(this.plot===null||this.motion.count===0||this.board.clientWidth===0)return;let e=this.motion.rowAt(t),[n,s]=this.choices.map(r=>{let o=Number(r.value),{scale:a,shift:l}=this.head.columns[o].display;return this.motion.at(e,o)*a+l});this.dot.style.left=`${this.plot.valToPos(n,"x")}px`,this.dot.style.top=`${this.plot.valToPos(s,"y")}px`}size(){return{width:Math.max(this.board.clientWidth||rl,240),height:240}}resize(){this.plot?.setSize(this.size())}};function kx(i){let[t,e]=i.data[1],{ctx:n}=i;return n.save(),n.beginPath(),n.rect(i.bbox.left,i.bbox.top,i.bbox.width,i.bbox.height),n.clip(),n.beginPath(),t.forEach((s,r)=>n.lineTo(i.valToPos(s,"x",!0),i.valToPos(e[r],"y",!0))),n.strokeStyle=Oo[0],n.lineWidth=1.5*window.devicePixelRatio,n.stroke(),n.restore(),null}var $p=4,ll=class{constructor(t,e,n,s){this.head=t;this.sought=s;this.motion=e,this.events=t.events;let r=this.columns(),o=r.filter(({column:c})=>c.kind==="coordinate").slice(0,$p);this.chosen=new Set((o.length>0?o:r.slice(0,$p)).map(({index:c})=>c));let a=document.createElement("details"),l=document.createElement("summary");l.textContent="Choose curves",a.append(l,...r.map(({column:c,index:h})=>this.choice(c,h))),this.board=document.createElement("div"),n.append(a,this.board),this.portrait=new al(t,e,n),new ResizeObserver(([{contentRect:c}])=>{this.seen=c.width>0,this.resize()}).observe(n),window.addEventListener("beforeprint",()=>{this.seen=!0,this.point(this.time)}),this.rebuild()}head;sought;charts=[];chosen;board;portrait;motion;events;family=[];time=0;seen=!1;columns(){return this.head.columns.map((t,e)=>({column:t,index:e})).slice(1,this.head.scene.first)}choice(t,e){let n=document.createElement("label");n.className="choice";let s=document.createElement("input");return s.type="checkbox",s.checked=this.chosen.has(e),s.onchange=()=>{s.checked?this.chosen.add(e):this.chosen.delete(e),this.rebuild()},n.append(s,`${t.name}${t.display.unit?` [${t.display.unit}]`:""}`),n.title=t.doc??"",n}rebuild(){for(let s of this.charts)s.plot.destroy();this.charts.length=0;let t=new Map;for(let s of[...this.chosen].sort((r,o)=>r-o)){let r=this.head.columns[s].display.unit;t.set(r,[...t.get(r)??[],s])}for(let[s,r]of t)this.overTime(s,r);let e=this.head.scene.first+this.head.scene.count,n={name:"energy",display:{unit:"J",scale:1,shift:0}};this.add("J",[n.name],s=>[s.column(0),s.column(e)]),this.point(this.time)}value(t,e){let{scale:n,shift:s}=this.head.columns[e].display;return t.column(e).map(r=>r*n+s)}overTime(t,e){let n=e.map(r=>this.head.columns[r].name),s=r=>e.map(o=>this.value(r,o));this.add(t,n,r=>[r.column(0),...s(r)])}underlay(t,e){let{ctx:n,bbox:s}=t;n.save(),n.beginPath(),n.rect(s.left,s.top,s.width,s.height),n.clip(),n.lineWidth=window.devicePixelRatio,n.strokeStyle="rgb(148 163 184 / 45%)";for(let r of this.family){let[o,...a]=e(r);for(let l of a)n.beginPath(),o.forEach((c,h)=>n.lineTo(t.valToPos(c,"x",!0),t.valToPos(l[h],"y",!0))),n.stroke()}n.strokeStyle="#dc2626";for(let{time:r,kind:o}of sl(this.events,t.scales.x.min??0,t.scales.x.max??1)){let a=t.valToPos(r,"x",!0);n.globalAlpha=o==="tick"?.25:1,n.beginPath(),n.moveTo(a,s.top+s.height),n.lineTo(a,s.top+s.height-7*window.devicePixelRatio),n.stroke()}n.restore()}range(t,e,n){let[s,r]=[e??0,n??1];for(let l of this.family)for(let c of t(l).slice(1))for(let h of c)Number.isFinite(h)&&([s,r]=[Math.min(s,h),Math.max(r,h)]);let o=Math.max(Math.abs(s),Math.abs(r)),a=Math.max(.06*(r-s),r-s<1e-6*o?.001*o:0,1e-12);return[s-a,r+a]}add(t,e,n){let s=new mn({...this.size(),scales:{x:{time:!1},y:{range:(r,o,a)=>this.range(n,o,a)}},axes:[{...Bo("t [s]"),size:40},ol(t===""?"":`[${t}]`)],cursor:{sync:{key:"time"},drag:{x:!1,y:!1}},series:[{label:"t",value:(r,o)=>Zp(o,"s")},...e.map((r,o)=>({label:r,stroke:Oo[o%Oo.length],width:1.5,value:(a,l)=>Zp(l,t)}))],hooks:{ready:[r=>r.over.addEventListener("click",()=>this.seek(r))],drawAxes:[r=>this.underlay(r,n)]}},n(this.motion),this.board);this.charts.push({plot:s,data:n})}seek(t){t.cursor.left!==void 0&&t.cursor.left>=0&&this.sought(t.posToVal(t.cursor.left,"x"))}show(t,e=[]){this.motion=t,this.events=e;for(let{plot:n,data:s}of this.charts)n.setData(s(t));this.portrait.show(t)}behind(t){this.family=t,this.rebuild()}point(t){if(this.time=t,!!this.seen){for(let{plot:e}of this.charts)e.setCursor({left:e.valToPos(t,"x"),top:-10},!1);this.portrait.point(t)}}size(){return{width:Math.max(this.board.clientWidth||rl,240),height:190}}resize(){for(let{plot:t}of this.charts)t.setSize(this.size());this.portrait.resize(),queueMicrotask(()=>this.point(this.time))}};function Zp(i,t){return i===null||!Number.isFinite(i)?"\u2013":`${Ir(i,5)} ${t}`}function Dr(i,t){let e=document.createElement("a");e.href=URL.createObjectURL(i),e.download=t,e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e3)}function Jp(i,t){i.toBlob(e=>e!==null&&Dr(e,`${t.name}.png`),"image/png")}function Kp(i,t){let e=t.columns.slice(0,t.scene.first),n=r=>/[",\n]/.test(r)?`"${r.replaceAll('"','""')}"`:r,s=[e.map(r=>n(r.name)).join(",")];for(let r=0;r<i.count;++r)s.push(e.map((o,a)=>i.at(r,a)).join(","));Dr(new Blob([`${s.join(`
`)}
`],{type:"text/csv"}),`${t.name}.csv`)}function jp(i,t){let e=[],n=new MediaRecorder(i.captureStream(60),{mimeType:"video/webm"});return n.ondataavailable=s=>e.push(s.data),n.onstop=()=>Dr(new Blob(e,{type:"video/webm"}),`${t.name}.webm`),n.start(),()=>n.stop()}var gu=class{list=[];put(...t){for(let e of t)this.list.push(e)}word(t){this.put(t&255,t>>8)}text(t){for(let e of t)this.put(e.charCodeAt(0))}get all(){return Uint8Array.from(this.list)}};function Vx(i,t,e){return(Math.round(i*5/255)*7+Math.round(t*6/255))*6+Math.round(e*5/255)}function Gx(i,t){let[e,n]=[256,257],s=new Map,[r,o,a,l]=[258,9,0,0],c=[],h=()=>{c.length>0&&t.put(c.length,...c),c=[]},u=d=>{for(a|=d<<l,l+=o;l>=8;)c.push(a&255),a>>=8,l-=8,c.length===255&&h()};t.put(8),u(e);let f=i[0];for(let d=1;d<i.length;++d){let g=f<<8|i[d],S=s.get(g);if(S!==void 0){f=S;continue}u(f),r<4096?(r===1<<o&&o<12&&++o,s.set(g,r++)):(u(e),s=new Map,[r,o]=[258,9]),f=i[d]}u(f),r===1<<o&&o<12&&++o,u(n),l>0&&c.push(a&255),h(),t.put(0)}function Qp(i,t){let e=new gu,{width:n,height:s}=i[0];e.text("GIF89a"),e.word(n),e.word(s),e.put(247,0,0);for(let r=0;r<256;++r){let[o,a,l]=[Math.floor(r/42),Math.floor(r/6)%7,r%6];e.put(Math.min(o*51,255),Math.min(Math.round(a*42.5),255),l*51)}e.put(33,255,11),e.text("NETSCAPE2.0"),e.put(3,1,0,0,0);for(let{data:r}of i){e.put(33,249,4,0),e.word(Math.round(t/10)),e.put(0,0,44,0,0,0,0),e.word(n),e.word(s),e.put(0);let o=new Uint8Array(n*s);for(let a=0;a<o.length;++a)o[a]=Vx(r[4*a],r[4*a+1],r[4*a+2]);Gx(o,e)}return e.put(59),new Blob([e.all],{type:"image/gif"})}function tm(i){return document.getElementById(i)?.textContent??""}function em(){return JSON.parse(tm("head"))}function Hx(i){let t=atob(i.trim()),e=new Uint8Array(t.length);for(let n=0;n<t.length;++n)e[n]=t.charCodeAt(n);return e}async function _u(i){let t=new Blob([Hx(i)]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function Nr(i){return _u(tm(i))}var Ur=class{constructor(t,e){this.width=t;this.values=e;this.count=Math.floor(e.length/t)}width;values;count;at(t,e){return this.values[t*this.width+e]}get last(){return this.count>0?this.at(this.count-1,0):0}rowAt(t){let e=0,n=this.count-1;for(;e<n;){let s=e+n+1>>1;this.at(s,0)<=t?e=s:n=s-1}return e}state(t,e){let n=this.rowAt(t),s=Math.min(n+1,this.count-1),r=this.at(s,0)-this.at(n,0),o=r>0?Math.min(Math.max((t-this.at(n,0))/r,0),1):0;for(let a=0;a<this.width;++a){let l=this.at(n,a);e[a]=l+o*(this.at(s,a)-l)}return e}largest(t){let e=0;for(let n=0;n<this.count;++n){let s=Math.abs(this.at(n,t));Number.isFinite(s)&&(e=Math.max(e,s))}return e}column(t){return Float64Array.from({length:this.count},(e,n)=>this.at(n,t))}};function nm(i,t){let e=new Float32Array(t.buffer),n=i.runs?.map(o=>o.rows)??[i.rows],s=e.length/n.reduce((o,a)=>o+a,0),r=0;return n.map(o=>{let a=new Float32Array(o*s);for(let l=0;l<s;++l)for(let c=0;c<o;++c)a[c*s+l]=e[r+l*o+c];return r+=o*s,new Ur(s,a)})}function xu(i){if(i.length===1)return i[0];let t=new Float32Array(i.reduce((n,s)=>n+s.values.length,0)),e=0;for(let n of i)t.set(n.values,e),e+=n.values.length;return new Ur(i[0].width,t)}var zo=class i{constructor(t,e,n){this.worker=t;this.width=e;this.told=n;t.onmessage=s=>this.arrived(s.data)}worker;width;told;busy=!1;waiting=null;number=0;static async begin(t,e,n,s="tape"){if(t.live===!1||typeof WebAssembly>"u"||typeof Worker>"u")return null;try{let r=new Blob([await Nr("worker")],{type:"text/javascript"}),o=new Worker(URL.createObjectURL(r)),a={wasm:(await Nr("wasm")).buffer,tape:(await Nr(s)).buffer,start:t.start,stop:t.stop,rows:e,tolerance:t.tolerance,lasting:t.lasting},l=await new Promise((c,h)=>{o.onmessage=u=>c(u.data.ready),o.onerror=u=>h(new Error(u.message)),o.postMessage(a,[a.wasm,a.tape])});return new i(o,l,n)}catch{return null}}run(t,e){this.waiting={parameters:t,inputs:e},this.busy||this.next()}next(){this.waiting!==null&&(this.worker.postMessage({number:++this.number,...this.waiting}),this.waiting=null,this.busy=!0)}arrived(t){this.busy=!1;let e=new Ur(this.width,t.rows);this.told({motion:e,status:t.status,time:t.time,took:t.took}),this.next()}};var Bs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},zs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Om=0,Zu=1,Bm=2;var va=1,zm=2,mo=3,ks=0,Xn=1,qn=2,sr=0,go=1,Ju=2,Ku=3,ju=4,km=5;var rr=100,Vm=101,Gm=102,Hm=103,Wm=104,Xm=200,qm=201,Ym=202,$m=203,Qu=204,tf=205,Zm=206,Jm=207,Km=208,jm=209,Qm=210,tg=211,eg=212,ng=213,ig=214,Fl=0,Ol=1,Bl=2,to=3,zl=4,kl=5,Vl=6,Gl=7,mc=0,sg=1,rg=2,Xi=0,ef=1,nf=2,sf=3,rf=4,of=5,af=6,lf=7;var cf=300,or=301,_o=302,gc=303,_c=304,Hl=1e3,ki=1001,Wl=1002,An=1003,og=1004;var Sa=1005;var Hn=1006,xc=1007;var ps=1008;var $n=1009,hf=1010,uf=1011,xo=1012,yc=1013,Ai=1014,Ci=1015,Ri=1016,vc=1017,Sc=1018,ar=1020,ff=35902,df=35899,pf=1021,mf=1022,Pi=1023,ls=1026,ms=1027,gf=1028,Mc=1029,Vs=1030,bc=1031;var wc=1033,Ma=33776,ba=33777,wa=33778,Ea=33779,Ec=35840,Tc=35841,Ac=35842,Cc=35843,Rc=36196,Pc=37492,Ic=37496,Lc=37488,Dc=37489,Ta=37490,Nc=37491,Uc=37808,Fc=37809,Oc=37810,Bc=37811,zc=37812,kc=37813,Vc=37814,Gc=37815,Hc=37816,Wc=37817,Xc=37818,qc=37819,Yc=37820,$c=37821,Zc=36492,Jc=36494,Kc=36495,jc=36283,Qc=36284,Aa=36285,th=36286;var Ko=2300,Xl=2301,Nl=2302,Vu=2303,Gu=2400,Hu=2401,Wu=2402;var ag=3200;var eh=0,lg=1,gs="",Vn="srgb",jo="srgb-linear",Qo="linear",De="srgb";var Ul=7680;var cg=519,hg=512,ug=513,fg=514,_f=515,dg=516,pg=517,xf=518,yf=519,vf=35044;var Sf="300 es",mi=2e3,eo=2001;function Wx(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Xx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ta(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function mg(){let i=ta("canvas");return i.style.display="block",i}var im={},no=null;function ea(...i){let t="THREE."+i.shift();no?no("log",t,...i):console.log(t,...i)}function gg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function se(...i){i=gg(i);let t="THREE."+i.shift();if(no)no("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ce(...i){i=gg(i);let t="THREE."+i.shift();if(no)no("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function $o(...i){let t=i.join(" ");t in im||(im[t]=!0,se(...i))}function _g(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var xg={[Fl]:Fl,[Bl]:Vl,[zl]:zl,[to]:kl,[Ol]:Ol,[Vl]:Bl,[Gl]:Gl,[kl]:to},Ti=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},In=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],sm=1234567,Zo=Math.PI/180,io=180/Math.PI;function Gs(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(In[i&255]+In[i>>8&255]+In[i>>16&255]+In[i>>24&255]+"-"+In[t&255]+In[t>>8&255]+"-"+In[t>>16&15|64]+In[t>>24&255]+"-"+In[e&63|128]+In[e>>8&255]+"-"+In[e>>16&255]+In[e>>24&255]+In[n&255]+In[n>>8&255]+In[n>>16&255]+In[n>>24&255]).toLowerCase()}function ye(i,t,e){return Math.max(t,Math.min(e,i))}function Mf(i,t){return(i%t+t)%t}function qx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Yx(i,t,e){return i!==t?(e-i)/(t-i):0}function Jo(i,t,e){return(1-e)*i+e*t}function $x(i,t,e,n){return Jo(i,t,1-Math.exp(-e*n))}function Zx(i,t=1){return t-Math.abs(Mf(i,t*2)-t)}function Jx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Kx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function jx(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Qx(i,t){return i+Math.random()*(t-i)}function ty(i){return i*(.5-Math.random())}function ey(i){i!==void 0&&(sm=i);let t=sm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function ny(i){return i*Zo}function iy(i){return i*io}function sy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function ry(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function bf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function oy(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*d,a*h,a*c);break;default:se("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function nh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function wf(i,t){if(t.constructor===Float32Array)return i;let e=nh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Ef(i,t){if(t.constructor===Float32Array)return i;let e=nh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var ih={DEG2RAD:Zo,RAD2DEG:io,generateUUID:Gs,clamp:ye,euclideanModulo:Mf,mapLinear:qx,inverseLerp:Yx,lerp:Jo,damp:$x,pingpong:Zx,smoothstep:Jx,smootherstep:Kx,randInt:jx,randFloat:Qx,randFloatSpread:ty,seededRandom:ey,degToRad:ny,radToDeg:iy,isPowerOfTwo:sy,ceilPowerOfTwo:ry,floorPowerOfTwo:bf,setQuaternionFromProperEuler:oy,normalize:Ef,denormalize:wf},Kt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},oi=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],g=r[o+2],S=r[o+3];if(u!==S||l!==f||c!==d||h!==g){let m=l*f+c*d+h*g+u*S;m<0&&(f=-f,d=-d,g=-g,S=-S,m=-m);let p=1-a;if(m<.9995){let M=Math.acos(m),C=Math.sin(M);p=Math.sin(p*M)/C,a=Math.sin(a*M)/C,l=l*p+f*a,c=c*p+d*a,h=h*p+g*a,u=u*p+S*a}else{l=l*p+f*a,c=c*p+d*a,h=h*p+g*a,u=u*p+S*a;let M=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=M,c*=M,h*=M,u*=M}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*u+l*d-c*f,t[e+1]=l*g+h*f+c*u-a*d,t[e+2]=c*g+h*d+a*f-l*u,t[e+3]=h*g-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"YXZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"ZXY":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"ZYX":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"YZX":this._x=f*h*u+c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u-f*d*g;break;case"XZY":this._x=f*h*u-c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u+f*d*g;break;default:se("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(rm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(rm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return yu.copy(this).projectOnVector(t),this.sub(yu)}reflect(t){return this.sub(yu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},yu=new O,rm=new oi,oe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],g=n[8],S=s[0],m=s[3],p=s[6],M=s[1],C=s[4],v=s[7],R=s[2],A=s[5],y=s[8];return r[0]=o*S+a*M+l*R,r[3]=o*m+a*C+l*A,r[6]=o*p+a*v+l*y,r[1]=c*S+h*M+u*R,r[4]=c*m+h*C+u*A,r[7]=c*p+h*v+u*y,r[2]=f*S+d*M+g*R,r[5]=f*m+d*C+g*A,r[8]=f*p+d*v+g*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,g=e*u+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/g;return t[0]=u*S,t[1]=(s*c-h*n)*S,t[2]=(a*n-s*o)*S,t[3]=f*S,t[4]=(h*e-s*l)*S,t[5]=(s*r-a*e)*S,t[6]=d*S,t[7]=(n*l-c*e)*S,t[8]=(o*e-n*r)*S,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return $o("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vu.makeScale(t,e)),this}rotate(t){return $o("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vu.makeRotation(-t)),this}translate(t,e){return $o("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},vu=new oe,om=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),am=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ay(){let i={enabled:!0,workingColorSpace:jo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===De&&(s.r=as(s.r),s.g=as(s.g),s.b=as(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===De&&(s.r=Qr(s.r),s.g=Qr(s.g),s.b=Qr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===gs?Qo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[jo]:{primaries:t,whitePoint:n,transfer:Qo,toXYZ:om,fromXYZ:am,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Vn},outputColorSpaceConfig:{drawingBufferColorSpace:Vn}},[Vn]:{primaries:t,whitePoint:n,transfer:De,toXYZ:om,fromXYZ:am,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Vn}}}),i}var we=ay();function as(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Qr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Fr,ql=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Fr===void 0&&(Fr=ta("canvas")),Fr.width=t.width,Fr.height=t.height;let s=Fr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Fr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ta("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=as(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(as(e[n]/255)*255):e[n]=as(e[n]);return{data:e,width:t.width,height:t.height}}else return se("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},ly=0,so=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ly++}),this.uuid=Gs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Su(s[o].image)):r.push(Su(s[o]))}else r=Su(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Su(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ql.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(se("Texture: Unable to serialize Texture."),{})}var cy=0,Mu=new O,Wn=class i extends Ti{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ki,s=ki,r=Hn,o=ps,a=Pi,l=$n,c=i.DEFAULT_ANISOTROPY,h=gs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:cy++}),this.uuid=Gs(),this.name="",this.source=new so(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Kt(0,0),this.repeat=new Kt(1,1),this.center=new Kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Mu).x}get height(){return this.source.getSize(Mu).y}get depth(){return this.source.getSize(Mu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){se(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){se(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==cf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Hl:t.x=t.x-Math.floor(t.x);break;case ki:t.x=t.x<0?0:1;break;case Wl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Hl:t.y=t.y-Math.floor(t.y);break;case ki:t.y=t.y<0?0:1;break;case Wl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Wn.DEFAULT_IMAGE=null;Wn.DEFAULT_MAPPING=cf;Wn.DEFAULT_ANISOTROPY=1;var Ae=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],g=l[9],S=l[2],m=l[6],p=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-S)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+S)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let C=(c+1)/2,v=(d+1)/2,R=(p+1)/2,A=(h+f)/4,y=(u+S)/4,T=(g+m)/4;return C>v&&C>R?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=A/n,r=y/n):v>R?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=A/s,r=T/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=T/r),this.set(n,s,r,e),this}let M=Math.sqrt((m-g)*(m-g)+(u-S)*(u-S)+(f-h)*(f-h));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(u-S)/M,this.z=(f-h)/M,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Yl=class extends Ti{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Hn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ae(0,0,t,e),this.scissorTest=!1,this.viewport=new Ae(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Wn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Hn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new so(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends Yl{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},na=class extends Wn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=An,this.minFilter=An,this.wrapR=ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var $l=class extends Wn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=An,this.minFilter=An,this.wrapR=ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ve=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,f,d,g,S,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,d,g,S,m)}set(t,e,n,s,r,o,a,l,c,h,u,f,d,g,S,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=f,p[3]=d,p[7]=g,p[11]=S,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Or.setFromMatrixColumn(t,0).length(),r=1/Or.setFromMatrixColumn(t,1).length(),o=1/Or.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,g=a*h,S=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+g*c,e[5]=f-S*c,e[9]=-a*l,e[2]=S-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,g=c*h,S=c*u;e[0]=f+S*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=S+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,g=c*h,S=c*u;e[0]=f-S*a,e[4]=-o*u,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=S-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,g=a*h,S=a*u;e[0]=l*h,e[4]=g*c-d,e[8]=f*c+S,e[1]=l*u,e[5]=S*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,g=a*l,S=a*c;e[0]=l*h,e[4]=S-f*u,e[8]=g*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+g,e[10]=f-S*u}else if(t.order==="XZY"){let f=o*l,d=o*c,g=a*l,S=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+S,e[5]=o*h,e[9]=d*u-g,e[2]=g*u-d,e[6]=a*h,e[10]=S*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(hy,t,uy)}lookAt(t,e,n){let s=this.elements;return ii.subVectors(t,e),ii.lengthSq()===0&&(ii.z=1),ii.normalize(),As.crossVectors(n,ii),As.lengthSq()===0&&(Math.abs(n.z)===1?ii.x+=1e-4:ii.z+=1e-4,ii.normalize(),As.crossVectors(n,ii)),As.normalize(),cl.crossVectors(ii,As),s[0]=As.x,s[4]=cl.x,s[8]=ii.x,s[1]=As.y,s[5]=cl.y,s[9]=ii.y,s[2]=As.z,s[6]=cl.z,s[10]=ii.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],g=n[2],S=n[6],m=n[10],p=n[14],M=n[3],C=n[7],v=n[11],R=n[15],A=s[0],y=s[4],T=s[8],k=s[12],U=s[1],L=s[5],V=s[9],X=s[13],D=s[2],H=s[6],q=s[10],G=s[14],ct=s[3],Y=s[7],j=s[11],it=s[15];return r[0]=o*A+a*U+l*D+c*ct,r[4]=o*y+a*L+l*H+c*Y,r[8]=o*T+a*V+l*q+c*j,r[12]=o*k+a*X+l*G+c*it,r[1]=h*A+u*U+f*D+d*ct,r[5]=h*y+u*L+f*H+d*Y,r[9]=h*T+u*V+f*q+d*j,r[13]=h*k+u*X+f*G+d*it,r[2]=g*A+S*U+m*D+p*ct,r[6]=g*y+S*L+m*H+p*Y,r[10]=g*T+S*V+m*q+p*j,r[14]=g*k+S*X+m*G+p*it,r[3]=M*A+C*U+v*D+R*ct,r[7]=M*y+C*L+v*H+R*Y,r[11]=M*T+C*V+v*q+R*j,r[15]=M*k+C*X+v*G+R*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],g=t[3],S=t[7],m=t[11],p=t[15],M=l*d-c*f,C=a*d-c*u,v=a*f-l*u,R=o*d-c*h,A=o*f-l*h,y=o*u-a*h;return e*(S*M-m*C+p*v)-n*(g*M-m*R+p*A)+s*(g*C-S*R+p*y)-r*(g*v-S*A+m*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],g=t[12],S=t[13],m=t[14],p=t[15],M=e*a-n*o,C=e*l-s*o,v=e*c-r*o,R=n*l-s*a,A=n*c-r*a,y=s*c-r*l,T=h*S-u*g,k=h*m-f*g,U=h*p-d*g,L=u*m-f*S,V=u*p-d*S,X=f*p-d*m,D=M*X-C*V+v*L+R*U-A*k+y*T;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return t[0]=(a*X-l*V+c*L)*H,t[1]=(s*V-n*X-r*L)*H,t[2]=(S*y-m*A+p*R)*H,t[3]=(f*A-u*y-d*R)*H,t[4]=(l*U-o*X-c*k)*H,t[5]=(e*X-s*U+r*k)*H,t[6]=(m*v-g*y-p*C)*H,t[7]=(h*y-f*v+d*C)*H,t[8]=(o*V-a*U+c*T)*H,t[9]=(n*U-e*V-r*T)*H,t[10]=(g*A-S*v+p*M)*H,t[11]=(u*v-h*A-d*M)*H,t[12]=(a*k-o*L-l*T)*H,t[13]=(e*L-n*k+s*T)*H,t[14]=(S*C-g*R-m*M)*H,t[15]=(h*R-u*C+f*M)*H,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,g=r*u,S=o*h,m=o*u,p=a*u,M=l*c,C=l*h,v=l*u,R=n.x,A=n.y,y=n.z;return s[0]=(1-(S+p))*R,s[1]=(d+v)*R,s[2]=(g-C)*R,s[3]=0,s[4]=(d-v)*A,s[5]=(1-(f+p))*A,s[6]=(m+M)*A,s[7]=0,s[8]=(g+C)*y,s[9]=(m-M)*y,s[10]=(1-(f+S))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Or.set(s[0],s[1],s[2]).length(),a=Or.set(s[4],s[5],s[6]).length(),l=Or.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bi.copy(this);let c=1/o,h=1/a,u=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=h,bi.elements[5]*=h,bi.elements[6]*=h,bi.elements[8]*=u,bi.elements[9]*=u,bi.elements[10]*=u,e.setFromRotationMatrix(bi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=mi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),g,S;if(l)g=r/(o-r),S=o*r/(o-r);else if(a===mi)g=-(o+r)/(o-r),S=-2*o*r/(o-r);else if(a===eo)g=-o/(o-r),S=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=S,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=mi,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),g,S;if(l)g=1/(o-r),S=o/(o-r);else if(a===mi)g=-2/(o-r),S=-(o+r)/(o-r);else if(a===eo)g=-1/(o-r),S=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=S,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Or=new O,bi=new ve,hy=new O(0,0,0),uy=new O(1,1,1),As=new O,cl=new O,ii=new O,lm=new ve,cm=new oi,cs=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ye(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:se("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return lm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(lm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return cm.setFromEuler(this),this.setFromQuaternion(cm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};cs.DEFAULT_ORDER="XYZ";var ro=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},fy=0,hm=new O,Br=new oi,es=new ve,hl=new O,ko=new O,dy=new O,py=new oi,um=new O(1,0,0),fm=new O(0,1,0),dm=new O(0,0,1),pm={type:"added"},my={type:"removed"},zr={type:"childadded",child:null},bu={type:"childremoved",child:null},gn=class i extends Ti{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:fy++}),this.uuid=Gs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new O,e=new cs,n=new oi,s=new O(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ve},normalMatrix:{value:new oe}}),this.matrix=new ve,this.matrixWorld=new ve,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ro,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Br.setFromAxisAngle(t,e),this.quaternion.multiply(Br),this}rotateOnWorldAxis(t,e){return Br.setFromAxisAngle(t,e),this.quaternion.premultiply(Br),this}rotateX(t){return this.rotateOnAxis(um,t)}rotateY(t){return this.rotateOnAxis(fm,t)}rotateZ(t){return this.rotateOnAxis(dm,t)}translateOnAxis(t,e){return hm.copy(t).applyQuaternion(this.quaternion),this.position.add(hm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(um,t)}translateY(t){return this.translateOnAxis(fm,t)}translateZ(t){return this.translateOnAxis(dm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(es.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?hl.copy(t):hl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ko.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?es.lookAt(ko,hl,this.up):es.lookAt(hl,ko,this.up),this.quaternion.setFromRotationMatrix(es),s&&(es.extractRotation(s.matrixWorld),Br.setFromRotationMatrix(es),this.quaternion.premultiply(Br.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ce("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(pm),zr.child=t,this.dispatchEvent(zr),zr.child=null):ce("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(my),bu.child=t,this.dispatchEvent(bu),bu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),es.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),es.multiply(t.parent.matrixWorld)),t.applyMatrix4(es),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(pm),zr.child=t,this.dispatchEvent(zr),zr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ko,t,dy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ko,py,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};gn.DEFAULT_UP=new O(0,1,0);gn.DEFAULT_MATRIX_AUTO_UPDATE=!0;gn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Dn=class extends gn{constructor(){super(),this.isGroup=!0,this.type="Group"}},gy={type:"move"},oo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Dn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Dn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Dn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let S of t.hand.values()){let m=e.getJointPose(S,n),p=this._getHandJoint(c,S);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(gy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Dn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},yg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Cs={h:0,s:0,l:0},ul={h:0,s:0,l:0};function wu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ee=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Vn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,we.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=we.workingColorSpace){return this.r=t,this.g=e,this.b=n,we.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=we.workingColorSpace){if(t=Mf(t,1),e=ye(e,0,1),n=ye(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=wu(o,r,t+1/3),this.g=wu(o,r,t),this.b=wu(o,r,t-1/3)}return we.colorSpaceToWorking(this,s),this}setStyle(t,e=Vn){function n(r){r!==void 0&&parseFloat(r)<1&&se("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:se("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);se("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Vn){let n=yg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):se("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=as(t.r),this.g=as(t.g),this.b=as(t.b),this}copyLinearToSRGB(t){return this.r=Qr(t.r),this.g=Qr(t.g),this.b=Qr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Vn){return we.workingToColorSpace(Ln.copy(this),t),Math.round(ye(Ln.r*255,0,255))*65536+Math.round(ye(Ln.g*255,0,255))*256+Math.round(ye(Ln.b*255,0,255))}getHexString(t=Vn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=we.workingColorSpace){we.workingToColorSpace(Ln.copy(this),e);let n=Ln.r,s=Ln.g,r=Ln.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=we.workingColorSpace){return we.workingToColorSpace(Ln.copy(this),e),t.r=Ln.r,t.g=Ln.g,t.b=Ln.b,t}getStyle(t=Vn){we.workingToColorSpace(Ln.copy(this),t);let e=Ln.r,n=Ln.g,s=Ln.b;return t!==Vn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Cs),this.setHSL(Cs.h+t,Cs.s+e,Cs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Cs),t.getHSL(ul);let n=Jo(Cs.h,ul.h,e),s=Jo(Cs.s,ul.s,e),r=Jo(Cs.l,ul.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ln=new ee;ee.NAMES=yg;var ia=class extends gn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new cs,this.environmentIntensity=1,this.environmentRotation=new cs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},wi=new O,ns=new O,Eu=new O,is=new O,kr=new O,Vr=new O,mm=new O,Tu=new O,Au=new O,Cu=new O,Ru=new Ae,Pu=new Ae,Iu=new Ae,os=class i{constructor(t=new O,e=new O,n=new O){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),wi.subVectors(t,e),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){wi.subVectors(s,e),ns.subVectors(n,e),Eu.subVectors(t,e);let o=wi.dot(wi),a=wi.dot(ns),l=wi.dot(Eu),c=ns.dot(ns),h=ns.dot(Eu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,is)===null?!1:is.x>=0&&is.y>=0&&is.x+is.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,is)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,is.x),l.addScaledVector(o,is.y),l.addScaledVector(a,is.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Ru.setScalar(0),Pu.setScalar(0),Iu.setScalar(0),Ru.fromBufferAttribute(t,e),Pu.fromBufferAttribute(t,n),Iu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ru,r.x),o.addScaledVector(Pu,r.y),o.addScaledVector(Iu,r.z),o}static isFrontFacing(t,e,n,s){return wi.subVectors(n,e),ns.subVectors(t,e),wi.cross(ns).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wi.subVectors(this.c,this.b),ns.subVectors(this.a,this.b),wi.cross(ns).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;kr.subVectors(s,n),Vr.subVectors(r,n),Tu.subVectors(t,n);let l=kr.dot(Tu),c=Vr.dot(Tu);if(l<=0&&c<=0)return e.copy(n);Au.subVectors(t,s);let h=kr.dot(Au),u=Vr.dot(Au);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(kr,o);Cu.subVectors(t,r);let d=kr.dot(Cu),g=Vr.dot(Cu);if(g>=0&&d<=g)return e.copy(r);let S=d*c-l*g;if(S<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(Vr,a);let m=h*g-d*u;if(m<=0&&u-h>=0&&d-g>=0)return mm.subVectors(r,s),a=(u-h)/(u-h+(d-g)),e.copy(s).addScaledVector(mm,a);let p=1/(m+S+f);return o=S*p,a=f*p,e.copy(n).addScaledVector(kr,o).addScaledVector(Vr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Yn=class{constructor(t=new O(1/0,1/0,1/0),e=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ei.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ei.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ei.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ei):Ei.fromBufferAttribute(r,o),Ei.applyMatrix4(t.matrixWorld),this.expandByPoint(Ei);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),fl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),fl.copy(n.boundingBox)),fl.applyMatrix4(t.matrixWorld),this.union(fl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ei),Ei.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Vo),dl.subVectors(this.max,Vo),Gr.subVectors(t.a,Vo),Hr.subVectors(t.b,Vo),Wr.subVectors(t.c,Vo),Rs.subVectors(Hr,Gr),Ps.subVectors(Wr,Hr),js.subVectors(Gr,Wr);let e=[0,-Rs.z,Rs.y,0,-Ps.z,Ps.y,0,-js.z,js.y,Rs.z,0,-Rs.x,Ps.z,0,-Ps.x,js.z,0,-js.x,-Rs.y,Rs.x,0,-Ps.y,Ps.x,0,-js.y,js.x,0];return!Lu(e,Gr,Hr,Wr,dl)||(e=[1,0,0,0,1,0,0,0,1],!Lu(e,Gr,Hr,Wr,dl))?!1:(pl.crossVectors(Rs,Ps),e=[pl.x,pl.y,pl.z],Lu(e,Gr,Hr,Wr,dl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ei).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ei).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ss[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ss[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ss[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ss[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ss[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ss[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ss[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ss[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ss),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ss=[new O,new O,new O,new O,new O,new O,new O,new O],Ei=new O,fl=new Yn,Gr=new O,Hr=new O,Wr=new O,Rs=new O,Ps=new O,js=new O,Vo=new O,dl=new O,pl=new O,Qs=new O;function Lu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Qs.fromArray(i,r);let a=s.x*Math.abs(Qs.x)+s.y*Math.abs(Qs.y)+s.z*Math.abs(Qs.z),l=t.dot(Qs),c=e.dot(Qs),h=n.dot(Qs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var un=new O,ml=new Kt,_y=0,Tn=class extends Ti{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:_y++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=vf,this.updateRanges=[],this.gpuType=Ci,this.version=0,this._normalizationScale=t!==void 0?nh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ml.fromBufferAttribute(this,e),ml.applyMatrix3(t),this.setXY(e,ml.x,ml.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)un.fromBufferAttribute(this,e),un.applyMatrix3(t),this.setXYZ(e,un.x,un.y,un.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)un.fromBufferAttribute(this,e),un.applyMatrix4(t),this.setXYZ(e,un.x,un.y,un.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)un.fromBufferAttribute(this,e),un.applyNormalMatrix(t),this.setXYZ(e,un.x,un.y,un.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)un.fromBufferAttribute(this,e),un.transformDirection(t),this.setXYZ(e,un.x,un.y,un.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):wf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ef(t,this.array)}};var sa=class extends Tn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ra=class extends Tn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Je=class extends Tn{constructor(t,e,n){super(new Float32Array(t),e,n)}},xy=new Yn,Go=new O,Du=new O,nr=class{constructor(t=new O,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):xy.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Go.subVectors(t,this.center);let e=Go.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Go,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Du.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Go.copy(t.center).add(Du)),this.expandByPoint(Go.copy(t.center).sub(Du))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},yy=0,pi=new ve,Nu=new gn,Xr=new O,si=new Yn,Ho=new Yn,En=new O,rn=class i extends Ti{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:yy++}),this.uuid=Gs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Wx(t)?ra:sa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new oe().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return pi.makeRotationFromQuaternion(t),this.applyMatrix4(pi),this}rotateX(t){return pi.makeRotationX(t),this.applyMatrix4(pi),this}rotateY(t){return pi.makeRotationY(t),this.applyMatrix4(pi),this}rotateZ(t){return pi.makeRotationZ(t),this.applyMatrix4(pi),this}translate(t,e,n){return pi.makeTranslation(t,e,n),this.applyMatrix4(pi),this}scale(t,e,n){return pi.makeScale(t,e,n),this.applyMatrix4(pi),this}lookAt(t){return Nu.lookAt(t),Nu.updateMatrix(),this.applyMatrix4(Nu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Xr).negate(),this.translate(Xr.x,Xr.y,Xr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Je(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&se("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Yn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];si.setFromBufferAttribute(r),this.morphTargetsRelative?(En.addVectors(this.boundingBox.min,si.min),this.boundingBox.expandByPoint(En),En.addVectors(this.boundingBox.max,si.max),this.boundingBox.expandByPoint(En)):(this.boundingBox.expandByPoint(si.min),this.boundingBox.expandByPoint(si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ce('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new nr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(t){let n=this.boundingSphere.center;if(si.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ho.setFromBufferAttribute(a),this.morphTargetsRelative?(En.addVectors(si.min,Ho.min),si.expandByPoint(En),En.addVectors(si.max,Ho.max),si.expandByPoint(En)):(si.expandByPoint(Ho.min),si.expandByPoint(Ho.max))}si.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)En.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(En));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)En.fromBufferAttribute(a,c),l&&(Xr.fromBufferAttribute(t,c),En.add(Xr)),s=Math.max(s,n.distanceToSquared(En))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ce('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ce("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Tn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new O,l[k]=new O;let h=new O,u=new O,f=new O,d=new Kt,g=new Kt,S=new Kt,m=new O,p=new O;function M(k,U,L){c[k]=c[U]=c[L]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,U),f.fromBufferAttribute(n,L),d.fromBufferAttribute(r,k),g.fromBufferAttribute(r,U),S.fromBufferAttribute(r,L),u.sub(h),f.sub(h),g.sub(d),S.sub(d);let V=1/(g.x*S.y-S.x*g.y);isFinite(V)&&(m.copy(u).multiplyScalar(S.y).addScaledVector(f,-g.y).multiplyScalar(V),p.copy(f).multiplyScalar(g.x).addScaledVector(u,-S.x).multiplyScalar(V),a[k].add(m),a[U].add(m),a[L].add(m),l[k].add(p),l[U].add(p),l[L].add(p))}let C=this.groups;C.length===0&&(C=[{start:0,count:t.count}]);for(let k=0,U=C.length;k<U;++k){let L=C[k],V=L.start,X=L.count;for(let D=V,H=V+X;D<H;D+=3)M(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let v=new O,R=new O,A=new O,y=new O;function T(k){A.fromBufferAttribute(s,k),y.copy(A);let U=a[k];v.copy(U),v.sub(A.multiplyScalar(A.dot(U))).normalize(),R.crossVectors(y,U);let V=R.dot(l[k])<0?-1:1;o.setXYZW(k,v.x,v.y,v.z,V)}for(let k=0,U=n.count;k<U;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Tn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new O,r=new O,o=new O,a=new O,l=new O,c=new O,h=new O,u=new O;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),S=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,S),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,S),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(S,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)En.fromBufferAttribute(t,e),En.normalize(),t.setXYZ(e,En.x,En.y,En.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,g=0;for(let S=0,m=l.length;S<m;S++){a.isInterleavedBufferAttribute?d=l[S]*a.data.stride+a.offset:d=l[S]*h;for(let p=0;p<h;p++)f[g++]=c[d++]}return new Tn(f,h,u)}if(this.index===null)return se("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},oa=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=vf,this.updateRanges=[],this.version=0,this.uuid=Gs()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=gm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=gm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function gm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Gs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var kn=new O,ao=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?nh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)kn.fromBufferAttribute(this,e),kn.applyMatrix4(t),this.setXYZ(e,kn.x,kn.y,kn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)kn.fromBufferAttribute(this,e),kn.applyNormalMatrix(t),this.setXYZ(e,kn.x,kn.y,kn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)kn.fromBufferAttribute(this,e),kn.transformDirection(t),this.setXYZ(e,kn.x,kn.y,kn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){ea("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Tn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){ea("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):wf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ef(t,this.data.array)}},Uu=new O,vy=new O,Sy=new oe,ri=class{constructor(t=new O(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Uu.subVectors(n,e).cross(vy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Uu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Sy.getNormalMatrix(t),s=this.coplanarPoint(Uu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},My=0,Vi=class extends Ti{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:My++}),this.uuid=Gs(),this.name="",this.type="Material",this.blending=go,this.side=ks,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qu,this.blendDst=tf,this.blendEquation=rr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=to,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=cg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ul,this.stencilZFail=Ul,this.stencilZPass=Ul,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){se(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){se(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new ri().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Kt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},lo=class extends Vi{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},qr,Wo=new O,Yr=new O,$r=new O,Zr=new Kt,Xo=new Kt,vg=new ve,gl=new O,qo=new O,_l=new O,_m=new Kt,Fu=new Kt,xm=new Kt,hs=class extends gn{constructor(t=new lo){if(super(),this.isSprite=!0,this.type="Sprite",qr===void 0){qr=new rn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new oa(e,5);qr.setIndex([0,1,2,0,2,3]),qr.setAttribute("position",new ao(n,3,0,!1)),qr.setAttribute("uv",new ao(n,2,3,!1))}this.geometry=qr,this.material=t,this.center=new Kt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ce('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Yr.setFromMatrixScale(this.matrixWorld),vg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),$r.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Yr.multiplyScalar(-$r.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;xl(gl.set(-.5,-.5,0),$r,o,Yr,s,r),xl(qo.set(.5,-.5,0),$r,o,Yr,s,r),xl(_l.set(.5,.5,0),$r,o,Yr,s,r),_m.set(0,0),Fu.set(1,0),xm.set(1,1);let a=t.ray.intersectTriangle(gl,qo,_l,!1,Wo);if(a===null&&(xl(qo.set(-.5,.5,0),$r,o,Yr,s,r),Fu.set(0,1),a=t.ray.intersectTriangle(gl,_l,qo,!1,Wo),a===null))return;let l=t.ray.origin.distanceTo(Wo);l<t.near||l>t.far||e.push({distance:l,point:Wo.clone(),uv:os.getInterpolation(Wo,gl,qo,_l,_m,Fu,xm,new Kt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function xl(i,t,e,n,s,r){Zr.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(Xo.x=r*Zr.x-s*Zr.y,Xo.y=s*Zr.x+r*Zr.y):Xo.copy(Zr),i.copy(t),i.x+=Xo.x,i.y+=Xo.y,i.applyMatrix4(vg)}var rs=new O,Ou=new O,yl=new O,vl=new O,Ls=class{constructor(t=new O,e=new O(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,rs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=rs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(rs.copy(this.origin).addScaledVector(this.direction,e),rs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ou.copy(t).add(e).multiplyScalar(.5),yl.copy(e).sub(t).normalize(),vl.copy(this.origin).sub(Ou);let r=t.distanceTo(e)*.5,o=-this.direction.dot(yl),a=vl.dot(this.direction),l=-vl.dot(yl),c=vl.lengthSq(),h=Math.abs(1-o*o),u,f,d,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let S=1/h;u*=S,f*=S,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Ou).addScaledVector(yl,f),d}intersectSphere(t,e){if(t.radius<0)return null;rs.subVectors(t.center,this.origin);let n=rs.dot(this.direction),s=rs.dot(rs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,rs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,g=e.x-o.x,S=e.y-o.y,m=e.z-o.z,p=n.x-o.x,M=n.y-o.y,C=n.z-o.z,v=Math.abs(l),R=Math.abs(c),A=Math.abs(h),y,T,k,U,L,V,X,D,H,q,G,ct;if(v>=R&&v>=A?(k=l,V=u,H=g,ct=p,l>=0?(y=c,T=h,U=f,L=d,X=S,D=m,q=M,G=C):(y=h,T=c,U=d,L=f,X=m,D=S,q=C,G=M)):R>=A?(k=c,V=f,H=S,ct=M,c>=0?(y=h,T=l,U=d,L=u,X=m,D=g,q=C,G=p):(y=l,T=h,U=u,L=d,X=g,D=m,q=p,G=C)):(k=h,V=d,H=m,ct=C,h>=0?(y=l,T=c,U=u,L=f,X=g,D=S,q=p,G=M):(y=c,T=l,U=f,L=u,X=S,D=g,q=M,G=p)),k===0)return null;let Y=y/k,j=T/k,it=1/k,pt=U-Y*V,ht=L-j*V,tt=X-Y*H,gt=D-j*H,Mt=q-Y*ct,Lt=G-j*ct,At=Mt*gt-Lt*tt,jt=pt*Lt-ht*Mt,he=tt*ht-gt*pt;if(s){if(At<0||jt<0||he<0)return null}else if((At<0||jt<0||he<0)&&(At>0||jt>0||he>0))return null;let Zt=At+jt+he;if(Zt===0)return null;let fe=it*(At*V+jt*H+he*ct);return(Zt>0?fe<0:fe>0)?null:this.at(fe/Zt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Zl=class extends Vi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new cs,this.combine=mc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},ym=new ve,tr=new Ls,Sl=new nr,vm=new O,Ml=new O,bl=new O,wl=new O,Bu=new O,El=new O,Sm=new O,Tl=new O,_n=class extends gn{constructor(t=new rn,e=new Zl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){El.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Bu.fromBufferAttribute(u,t),o?El.addScaledVector(Bu,h):El.addScaledVector(Bu.sub(e),h))}e.add(El)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Sl.copy(n.boundingSphere),Sl.applyMatrix4(r),tr.copy(t.ray).recast(t.near),!(Sl.containsPoint(tr.origin)===!1&&(tr.intersectSphere(Sl,vm)===null||tr.origin.distanceToSquared(vm)>(t.far-t.near)**2))&&(ym.copy(r).invert(),tr.copy(t.ray).applyMatrix4(ym),!(n.boundingBox!==null&&tr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,tr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,S=f.length;g<S;g++){let m=f[g],p=o[m.materialIndex],M=Math.max(m.start,d.start),C=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let v=M,R=C;v<R;v+=3){let A=a.getX(v),y=a.getX(v+1),T=a.getX(v+2);s=Al(this,p,t,n,c,h,u,A,y,T),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),S=Math.min(a.count,d.start+d.count);for(let m=g,p=S;m<p;m+=3){let M=a.getX(m),C=a.getX(m+1),v=a.getX(m+2);s=Al(this,o,t,n,c,h,u,M,C,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,S=f.length;g<S;g++){let m=f[g],p=o[m.materialIndex],M=Math.max(m.start,d.start),C=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let v=M,R=C;v<R;v+=3){let A=v,y=v+1,T=v+2;s=Al(this,p,t,n,c,h,u,A,y,T),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),S=Math.min(l.count,d.start+d.count);for(let m=g,p=S;m<p;m+=3){let M=m,C=m+1,v=m+2;s=Al(this,o,t,n,c,h,u,M,C,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function by(i,t,e,n,s,r,o,a){let l;if(t.side===Xn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===ks,a),l===null)return null;Tl.copy(a),Tl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Tl);return c<e.near||c>e.far?null:{distance:c,point:Tl.clone(),object:i}}function Al(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Ml),i.getVertexPosition(l,bl),i.getVertexPosition(c,wl);let h=by(i,t,e,n,Ml,bl,wl,Sm);if(h){let u=new O;os.getBarycoord(Sm,Ml,bl,wl,u),s&&(h.uv=os.getInterpolatedAttribute(s,a,l,c,u,new Kt)),r&&(h.uv1=os.getInterpolatedAttribute(r,a,l,c,u,new Kt)),o&&(h.normal=os.getInterpolatedAttribute(o,a,l,c,u,new O),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new O,materialIndex:0};os.getNormal(Ml,bl,wl,f.normal),h.face=f,h.barycoord=u}return h}var Jl=class extends Wn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=An,h=An,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var er=new nr,wy=new Kt(.5,.5),Cl=new O,Gi=class{constructor(t=new ri,e=new ri,n=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=mi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],g=r[8],S=r[9],m=r[10],p=r[11],M=r[12],C=r[13],v=r[14],R=r[15];if(s[0].setComponents(c-o,d-h,p-g,R-M).normalize(),s[1].setComponents(c+o,d+h,p+g,R+M).normalize(),s[2].setComponents(c+a,d+u,p+S,R+C).normalize(),s[3].setComponents(c-a,d-u,p-S,R-C).normalize(),n)s[4].setComponents(l,f,m,v).normalize(),s[5].setComponents(c-l,d-f,p-m,R-v).normalize();else if(s[4].setComponents(c-l,d-f,p-m,R-v).normalize(),e===mi)s[5].setComponents(c+l,d+f,p+m,R+v).normalize();else if(e===eo)s[5].setComponents(l,f,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),er.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),er.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(er)}intersectsSprite(t){er.center.set(0,0,0);let e=wy.distanceTo(t.center);return er.radius=.7071067811865476+e,er.applyMatrix4(t.matrixWorld),this.intersectsSphere(er)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Cl.x=s.normal.x>0?t.max.x:t.min.x,Cl.y=s.normal.y>0?t.max.y:t.min.y,Cl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Cl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Mm=new ve,Kl=class i{constructor(){this.coordinateSystem=mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Mm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Gi),n[s].setFromProjectionMatrix(Mm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Gi),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Ds=class extends Vi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},jl=new O,Ql=new O,bm=new ve,Yo=new Ls,Rl=new nr,zu=new O,wm=new O,us=class extends gn{constructor(t=new rn,e=new Ds){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)jl.fromBufferAttribute(e,s-1),Ql.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=jl.distanceTo(Ql);t.setAttribute("lineDistance",new Je(n,1))}else se("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Rl.copy(n.boundingSphere),Rl.applyMatrix4(s),Rl.radius+=r,t.ray.intersectsSphere(Rl)===!1)return;bm.copy(s).invert(),Yo.copy(t.ray).applyMatrix4(bm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let S=d,m=g-1;S<m;S+=c){let p=h.getX(S),M=h.getX(S+1),C=Pl(this,t,Yo,l,p,M,S);C&&e.push(C)}if(this.isLineLoop){let S=h.getX(g-1),m=h.getX(d),p=Pl(this,t,Yo,l,S,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let S=d,m=g-1;S<m;S+=c){let p=Pl(this,t,Yo,l,S,S+1,S);p&&e.push(p)}if(this.isLineLoop){let S=Pl(this,t,Yo,l,g-1,d,g-1);S&&e.push(S)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Pl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(jl.fromBufferAttribute(a,s),Ql.fromBufferAttribute(a,r),e.distanceSqToSegment(jl,Ql,zu,wm)>n)return;zu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(zu);if(!(c<t.near||c>t.far))return{distance:c,point:wm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Em=new O,Tm=new O,co=class extends us{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Em.fromBufferAttribute(e,s),Tm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Em.distanceTo(Tm);t.setAttribute("lineDistance",new Je(n,1))}else se("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var aa=class extends Wn{constructor(t=[],e=or,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},la=class extends Wn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var fs=class extends Wn{constructor(t,e,n=Ai,s,r,o,a=An,l=An,c,h=ls,u=1){if(h!==ls&&h!==ms)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new so(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ca=class extends fs{constructor(t,e=Ai,n=or,s,r,o=An,a=An,l,c=ls){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ha=class extends Wn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Hi=class i extends rn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Je(c,3)),this.setAttribute("normal",new Je(h,3)),this.setAttribute("uv",new Je(u,2));function g(S,m,p,M,C,v,R,A,y,T,k){let U=v/y,L=R/T,V=v/2,X=R/2,D=A/2,H=y+1,q=T+1,G=0,ct=0,Y=new O;for(let j=0;j<q;j++){let it=j*L-X;for(let pt=0;pt<H;pt++){let ht=pt*U-V;Y[S]=ht*M,Y[m]=it*C,Y[p]=D,c.push(Y.x,Y.y,Y.z),Y[S]=0,Y[m]=0,Y[p]=A>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(pt/y),u.push(1-j/T),G+=1}}for(let j=0;j<T;j++)for(let it=0;it<y;it++){let pt=f+it+H*j,ht=f+it+H*(j+1),tt=f+(it+1)+H*(j+1),gt=f+(it+1)+H*j;l.push(pt,ht,gt),l.push(ht,tt,gt),ct+=6}a.addGroup(d,ct,k),d+=ct,f+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ua=class i extends rn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],g=[],S=[],m=[];for(let p=0;p<h;p++){let M=p*f-o;for(let C=0;C<c;C++){let v=C*u-r;g.push(v,-M,0),S.push(0,0,1),m.push(C/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let M=0;M<a;M++){let C=M+c*p,v=M+c*(p+1),R=M+1+c*(p+1),A=M+1+c*p;d.push(C,v,A),d.push(v,R,A)}this.setIndex(d),this.setAttribute("position",new Je(g,3)),this.setAttribute("normal",new Je(S,3)),this.setAttribute("uv",new Je(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var fa=class i extends rn{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],f=new O,d=new O,g=new O;for(let S=0;S<=n;S++){let m=o+S/n*a;for(let p=0;p<=s;p++){let M=p/s*r;d.x=(t+e*Math.cos(m))*Math.cos(M),d.y=(t+e*Math.cos(m))*Math.sin(M),d.z=e*Math.sin(m),c.push(d.x,d.y,d.z),f.x=t*Math.cos(M),f.y=t*Math.sin(M),g.subVectors(d,f).normalize(),h.push(g.x,g.y,g.z),u.push(p/s),u.push(S/n)}}for(let S=1;S<=n;S++)for(let m=1;m<=s;m++){let p=(s+1)*S+m-1,M=(s+1)*(S-1)+m-1,C=(s+1)*(S-1)+m,v=(s+1)*S+m;l.push(p,M,v),l.push(M,C,v)}this.setIndex(l),this.setAttribute("position",new Je(c,3)),this.setAttribute("normal",new Je(h,3)),this.setAttribute("uv",new Je(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function lr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Am(s))s.isRenderTargetTexture?(se("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Am(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Nn(i){let t={};for(let e=0;e<i.length;e++){let n=lr(i[e]);for(let s in n)t[s]=n[s]}return t}function Am(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Ey(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Tf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:we.workingColorSpace}var Sg={clone:lr,merge:Nn},Ty=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ay=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Wi=class extends Vi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ty,this.fragmentShader=Ay,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=lr(t.uniforms),this.uniformsGroups=Ey(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new ee().setHex(s.value);break;case"v2":this.uniforms[n].value=new Kt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new O().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ae().fromArray(s.value);break;case"m3":this.uniforms[n].value=new oe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ve().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},tc=class extends Wi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ds=class extends Vi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ee(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=eh,this.normalScale=new Kt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new cs,this.combine=mc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},ec=class extends Vi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ag,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},nc=class extends Vi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Jr(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Il(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ns=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ic=class extends Ns{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gu,endingEnd:Gu}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hu:r=t,a=2*e-n;break;case Wu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Hu:o=t,l=2*n-e;break;case Wu:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(n-e)/(s-e),S=g*g,m=S*g,p=-f*m+2*f*S-f*g,M=(1+f)*m+(-1.5-2*f)*S+(-.5+f)*g+1,C=(-1-d)*m+(1.5+d)*S+.5*g,v=d*m-d*S;for(let R=0;R!==a;++R)r[R]=p*o[h+R]+M*o[c+R]+C*o[l+R]+v*o[u+R];return r}},sc=class extends Ns{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},rc=class extends Ns{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},oc=class extends Ns{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-e)/(s-e),S=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*S+o[l+m]*g;return r}let f=a*2,d=t-1;for(let g=0;g!==a;++g){let S=o[c+g],m=o[l+g],p=d*f+g*2,M=u[p],C=u[p+1],v=t*f+g*2,R=h[v],A=h[v+1],y=Ry(n,e,M,R,s);r[g]=Mg(y,S,C,A,m)}return r}};function Mg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Cy(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Ry(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Mg(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Cy(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var li=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Jr(e,this.TimeBufferType),this.values=Jr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Jr(t.times,Array),values:Jr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Il(t.settings)&&(n.settings={inTangents:Jr(t.settings.inTangents,Array),outTangents:Jr(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new rc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new sc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ic(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new oc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ko:e=this.InterpolantFactoryMethodDiscrete;break;case Xl:e=this.InterpolantFactoryMethodLinear;break;case Nl:e=this.InterpolantFactoryMethodSmooth;break;case Vu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return se("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ko;case this.InterpolantFactoryMethodLinear:return Xl;case this.InterpolantFactoryMethodSmooth:return Nl;case this.InterpolantFactoryMethodBezier:return Vu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Il(this.settings)&&(Cm(this.settings.inTangents,t),Cm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Il(this.settings)&&(Rm(this.settings.inTangents,t),Rm(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ce("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ce("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ce("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ce("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Xx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ce("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Nl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let g=0;g!==n;++g){let S=e[u+g];if(S!==e[f+g]||S!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Il(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Cm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Rm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=Xl;var Us=class extends li{constructor(t,e,n){super(t,e,n)}};Us.prototype.ValueTypeName="bool";Us.prototype.ValueBufferType=Array;Us.prototype.DefaultInterpolation=Ko;Us.prototype.InterpolantFactoryMethodLinear=void 0;Us.prototype.InterpolantFactoryMethodSmooth=void 0;var ac=class extends li{constructor(t,e,n,s){super(t,e,n,s)}};ac.prototype.ValueTypeName="color";var lc=class extends li{constructor(t,e,n,s){super(t,e,n,s)}};lc.prototype.ValueTypeName="number";var cc=class extends Ns{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)oi.slerpFlat(r,0,o,c-a,o,c,l);return r}},da=class extends li{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new cc(this.times,this.values,this.getValueSize(),t)}};da.prototype.ValueTypeName="quaternion";da.prototype.InterpolantFactoryMethodSmooth=void 0;var Fs=class extends li{constructor(t,e,n){super(t,e,n)}};Fs.prototype.ValueTypeName="string";Fs.prototype.ValueBufferType=Array;Fs.prototype.DefaultInterpolation=Ko;Fs.prototype.InterpolantFactoryMethodLinear=void 0;Fs.prototype.InterpolantFactoryMethodSmooth=void 0;var hc=class extends li{constructor(t,e,n,s){super(t,e,n,s)}};hc.prototype.ValueTypeName="vector";var uc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],g=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},bg=new uc,fc=class{constructor(t){this.manager=t!==void 0?t:bg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};fc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ho=class extends gn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ee(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},pa=class extends ho{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ee(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},ku=new ve,Pm=new O,Im=new O,dc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Kt(512,512),this.mapType=$n,this.map=null,this.mapPass=null,this.matrix=new ve,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gi,this._frameExtents=new Kt(1,1),this._viewportCount=1,this._viewports=[new Ae(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Pm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Pm),Im.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Im),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){ku.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(ku,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===eo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(ku)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Ll=new O,Dl=new oi,zi=new O,ir=class extends gn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ve,this.projectionMatrix=new ve,this.projectionMatrixInverse=new ve,this.coordinateSystem=mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Ll,Dl,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ll,Dl,zi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Ll,Dl,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ll,Dl,zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Is=new O,Lm=new Kt,Dm=new Kt,Gn=class extends ir{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=io*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Zo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return io*2*Math.atan(Math.tan(Zo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Is.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Is.x,Is.y).multiplyScalar(-t/Is.z),Is.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Is.x,Is.y).multiplyScalar(-t/Is.z)}getViewSize(t,e){return this.getViewBounds(t,Lm,Dm),e.subVectors(Dm,Lm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Zo*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Os=class extends ir{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Xu=class extends dc{constructor(){super(new Os(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ma=class extends ho{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.target=new gn,this.shadow=new Xu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},ga=class extends ho{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Kr=-90,jr=1,uo=class extends gn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Gn(Kr,jr,t,e);s.layers=this.layers,this.add(s);let r=new Gn(Kr,jr,t,e);r.layers=this.layers,this.add(r);let o=new Gn(Kr,jr,t,e);o.layers=this.layers,this.add(o);let a=new Gn(Kr,jr,t,e);a.layers=this.layers,this.add(a);let l=new Gn(Kr,jr,t,e);l.layers=this.layers,this.add(l);let c=new Gn(Kr,jr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===eo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},pc=class extends Gn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Af="\\[\\]\\.:\\/",Py=new RegExp("["+Af+"]","g"),Cf="[^"+Af+"]",Iy="[^"+Af.replace("\\.","")+"]",Ly=/((?:WC+[\/:])*)/.source.replace("WC",Cf),Dy=/(WCOD+)?/.source.replace("WCOD",Iy),Ny=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Cf),Uy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Cf),Fy=new RegExp("^"+Ly+Dy+Ny+Uy+"$"),Oy=["material","materials","bones","map"],qu=class{constructor(t,e,n){let s=n||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Py,"")}static parseTrackName(t){let e=Fy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Oy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){se("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ce("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ce("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ce("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ce("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ce("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ce("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=qu;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var $E=new Float32Array(1);var Nm=new ve,_a=class{constructor(t,e,n=0,s=1/0){this.ray=new Ls(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new ro,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ce("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Nm.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Nm),this}intersectObject(t,e=!0,n=[]){return Yu(t,this,n,e),n.sort(Um),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)Yu(t[s],this,n,e);return n.sort(Um),n}};function Um(i,t){return i.distance-t.distance}function Yu(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Yu(r[o],t,e,!0)}}var fo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ye(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var $u=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}},Fm=new Kt,po=class{constructor(t=new Kt(1/0,1/0),e=new Kt(-1/0,-1/0)){this.isBox2=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Fm.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=1/0,this.max.x=this.max.y=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y}getCenter(t){return this.isEmpty()?t.set(0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Fm).distanceTo(t)}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}};var xa=class extends co{constructor(t=10,e=10,n=4473924,s=8947848){n=new ee(n),s=new ee(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,g=-a;f<=e;f++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let S=f===r?n:s;S.toArray(c,d),d+=3,S.toArray(c,d),d+=3,S.toArray(c,d),d+=3,S.toArray(c,d),d+=3}let h=new rn;h.setAttribute("position",new Je(l,3)),h.setAttribute("color",new Je(c,3));let u=new Ds({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ya=class extends Ti{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Rf(i,t,e,n){let s=By(n);switch(e){case pf:return i*t;case gf:return i*t/s.components*s.byteLength;case Mc:return i*t/s.components*s.byteLength;case Vs:return i*t*2/s.components*s.byteLength;case bc:return i*t*2/s.components*s.byteLength;case mf:return i*t*3/s.components*s.byteLength;case Pi:return i*t*4/s.components*s.byteLength;case wc:return i*t*4/s.components*s.byteLength;case Ma:case ba:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case wa:case Ea:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Tc:case Cc:return Math.max(i,16)*Math.max(t,8)/4;case Ec:case Ac:return Math.max(i,8)*Math.max(t,8)/2;case Rc:case Pc:case Lc:case Dc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ic:case Ta:case Nc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Uc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Fc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Oc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Bc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case zc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case kc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Vc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Gc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Hc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Wc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Xc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case qc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Yc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case $c:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Zc:case Jc:case Kc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case jc:case Qc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Aa:case th:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function By(i){switch(i){case $n:case hf:return{byteLength:1,components:1};case xo:case uf:case Ri:return{byteLength:2,components:1};case vc:case Sc:return{byteLength:2,components:4};case Ai:case yc:case Ci:return{byteLength:4,components:1};case ff:case df:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?se("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Xg(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Wy(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<u.length;d++){let g=u[f],S=u[d];S.start<=g.start+g.count+1?g.count=Math.max(g.count,S.start+S.count-g.start):(++f,u[f]=S)}u.length=f+1;for(let d=0,g=u.length;d<g;d++){let S=u[d];i.bufferSubData(c,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Xy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,qy=`#ifdef USE_ALPHAHASH
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
#endif`,Yy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$y=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Zy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Jy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ky=`#ifdef USE_AOMAP
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
#endif`,jy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Qy=`#ifdef USE_BATCHING
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
#endif`,tv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ev=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,nv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,iv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,sv=`#ifdef USE_IRIDESCENCE
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
#endif`,rv=`#ifdef USE_BUMPMAP
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
#endif`,ov=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,av=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,lv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,cv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,uv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,fv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,dv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,pv=`#define PI 3.141592653589793
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
} // validated`,mv=`vec3 transformedNormal = objectNormal;
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
#endif`,gv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,_v=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,yv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,vv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Sv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Mv=`#ifdef USE_ENVMAP
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
#endif`,bv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,wv=`#ifdef USE_ENVMAP
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
#endif`,Ev=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Tv=`#ifdef USE_ENVMAP
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
#endif`,Av=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Cv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Rv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Pv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Iv=`#ifdef USE_GRADIENTMAP
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
}`,Lv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Dv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Nv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Uv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Fv=`#ifdef USE_ENVMAP
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
#endif`,Ov=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Bv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,kv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Vv=`PhysicalMaterial material;
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
#endif`,Gv=`uniform sampler2D dfgLUT;
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
}`,Hv=`
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
#endif`,Wv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Xv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,qv=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Yv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$v=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Jv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Kv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,jv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Qv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,tS=`#if defined( USE_POINTS_UV )
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
#endif`,eS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,nS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,iS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sS=`#if defined( USE_MORPHCOLORS )
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
#endif`,rS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,oS=`#ifdef USE_MORPHTARGETS
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
#endif`,aS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,cS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,hS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,uS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,dS=`#ifdef USE_NORMALMAP
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
#endif`,pS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,mS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,gS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,_S=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,yS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,vS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,SS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,MS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,bS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ES=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,TS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,AS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,CS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,RS=`float getShadowMask() {
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
}`,PS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,IS=`#ifdef USE_SKINNING
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
#endif`,LS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,DS=`#ifdef USE_SKINNING
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
#endif`,NS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,US=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,FS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,OS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,BS=`#ifdef USE_TRANSMISSION
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
#endif`,zS=`#ifdef USE_TRANSMISSION
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
#endif`,kS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,VS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,GS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,HS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,WS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,XS=`uniform sampler2D t2D;
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
}`,qS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,YS=`uniform float backgroundBlurriness;
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
}`,$S=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ZS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,JS=`#include <common>
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
}`,KS=`#if DEPTH_PACKING == 3200
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
}`,jS=`#define DISTANCE
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
}`,QS=`#define DISTANCE
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
}`,tM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,eM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nM=`uniform float scale;
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
}`,iM=`uniform vec3 diffuse;
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
}`,sM=`#include <common>
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
}`,rM=`uniform vec3 diffuse;
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
}`,oM=`#define LAMBERT
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
}`,aM=`#define LAMBERT
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
}`,lM=`#define MATCAP
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
}`,cM=`#define MATCAP
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
}`,hM=`#define NORMAL
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
}`,uM=`#define NORMAL
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
}`,fM=`#define PHONG
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
}`,dM=`#define PHONG
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
}`,pM=`#define STANDARD
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
}`,mM=`#define STANDARD
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
}`,gM=`#define TOON
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
}`,_M=`#define TOON
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
}`,xM=`uniform float size;
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
}`,yM=`uniform vec3 diffuse;
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
}`,vM=`#include <common>
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
}`,SM=`uniform vec3 color;
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
}`,MM=`uniform float rotation;
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
}`,bM=`uniform vec3 diffuse;
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
}`,ge={alphahash_fragment:Xy,alphahash_pars_fragment:qy,alphamap_fragment:Yy,alphamap_pars_fragment:$y,alphatest_fragment:Zy,alphatest_pars_fragment:Jy,aomap_fragment:Ky,aomap_pars_fragment:jy,batching_pars_vertex:Qy,batching_vertex:tv,begin_vertex:ev,beginnormal_vertex:nv,bsdfs:iv,iridescence_fragment:sv,bumpmap_pars_fragment:rv,clipping_planes_fragment:ov,clipping_planes_pars_fragment:av,clipping_planes_pars_vertex:lv,clipping_planes_vertex:cv,color_fragment:hv,color_pars_fragment:uv,color_pars_vertex:fv,color_vertex:dv,common:pv,defaultnormal_vertex:mv,displacementmap_pars_vertex:gv,displacementmap_vertex:_v,emissivemap_fragment:xv,emissivemap_pars_fragment:yv,colorspace_fragment:vv,colorspace_pars_fragment:Sv,envmap_fragment:Mv,envmap_common_pars_fragment:bv,envmap_pars_fragment:wv,envmap_pars_vertex:Ev,envmap_physical_pars_fragment:Fv,envmap_vertex:Tv,fog_vertex:Av,fog_pars_vertex:Cv,fog_fragment:Rv,fog_pars_fragment:Pv,gradientmap_pars_fragment:Iv,lightmap_pars_fragment:Lv,lights_lambert_fragment:Dv,lights_lambert_pars_fragment:Nv,lights_pars_begin:Uv,lights_toon_fragment:Ov,lights_toon_pars_fragment:Bv,lights_phong_fragment:zv,lights_phong_pars_fragment:kv,lights_physical_fragment:Vv,lights_physical_pars_fragment:Gv,lights_fragment_begin:Hv,lights_fragment_maps:Wv,lights_fragment_end:Xv,lightprobes_pars_fragment:qv,logdepthbuf_fragment:Yv,logdepthbuf_pars_fragment:$v,logdepthbuf_pars_vertex:Zv,logdepthbuf_vertex:Jv,map_fragment:Kv,map_pars_fragment:jv,map_particle_fragment:Qv,map_particle_pars_fragment:tS,metalnessmap_fragment:eS,metalnessmap_pars_fragment:nS,morphinstance_vertex:iS,morphcolor_vertex:sS,morphnormal_vertex:rS,morphtarget_pars_vertex:oS,morphtarget_vertex:aS,normal_fragment_begin:lS,normal_fragment_maps:cS,normal_pars_fragment:hS,normal_pars_vertex:uS,normal_vertex:fS,normalmap_pars_fragment:dS,clearcoat_normal_fragment_begin:pS,clearcoat_normal_fragment_maps:mS,clearcoat_pars_fragment:gS,iridescence_pars_fragment:_S,opaque_fragment:xS,packing:yS,premultiplied_alpha_fragment:vS,project_vertex:SS,dithering_fragment:MS,dithering_pars_fragment:bS,roughnessmap_fragment:wS,roughnessmap_pars_fragment:ES,shadowmap_pars_fragment:TS,shadowmap_pars_vertex:AS,shadowmap_vertex:CS,shadowmask_pars_fragment:RS,skinbase_vertex:PS,skinning_pars_vertex:IS,skinning_vertex:LS,skinnormal_vertex:DS,specularmap_fragment:NS,specularmap_pars_fragment:US,tonemapping_fragment:FS,tonemapping_pars_fragment:OS,transmission_fragment:BS,transmission_pars_fragment:zS,uv_pars_fragment:kS,uv_pars_vertex:VS,uv_vertex:GS,worldpos_vertex:HS,background_vert:WS,background_frag:XS,backgroundCube_vert:qS,backgroundCube_frag:YS,cube_vert:$S,cube_frag:ZS,depth_vert:JS,depth_frag:KS,distance_vert:jS,distance_frag:QS,equirect_vert:tM,equirect_frag:eM,linedashed_vert:nM,linedashed_frag:iM,meshbasic_vert:sM,meshbasic_frag:rM,meshlambert_vert:oM,meshlambert_frag:aM,meshmatcap_vert:lM,meshmatcap_frag:cM,meshnormal_vert:hM,meshnormal_frag:uM,meshphong_vert:fM,meshphong_frag:dM,meshphysical_vert:pM,meshphysical_frag:mM,meshtoon_vert:gM,meshtoon_frag:_M,points_vert:xM,points_frag:yM,shadow_vert:vM,shadow_frag:SM,sprite_vert:MM,sprite_frag:bM},zt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new Kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},Yi={basic:{uniforms:Nn([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.fog]),vertexShader:ge.meshbasic_vert,fragmentShader:ge.meshbasic_frag},lambert:{uniforms:Nn([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:ge.meshlambert_vert,fragmentShader:ge.meshlambert_frag},phong:{uniforms:Nn([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ge.meshphong_vert,fragmentShader:ge.meshphong_frag},standard:{uniforms:Nn([zt.common,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.roughnessmap,zt.metalnessmap,zt.fog,zt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag},toon:{uniforms:Nn([zt.common,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.gradientmap,zt.fog,zt.lights,{emissive:{value:new ee(0)}}]),vertexShader:ge.meshtoon_vert,fragmentShader:ge.meshtoon_frag},matcap:{uniforms:Nn([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,{matcap:{value:null}}]),vertexShader:ge.meshmatcap_vert,fragmentShader:ge.meshmatcap_frag},points:{uniforms:Nn([zt.points,zt.fog]),vertexShader:ge.points_vert,fragmentShader:ge.points_frag},dashed:{uniforms:Nn([zt.common,zt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ge.linedashed_vert,fragmentShader:ge.linedashed_frag},depth:{uniforms:Nn([zt.common,zt.displacementmap]),vertexShader:ge.depth_vert,fragmentShader:ge.depth_frag},normal:{uniforms:Nn([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,{opacity:{value:1}}]),vertexShader:ge.meshnormal_vert,fragmentShader:ge.meshnormal_frag},sprite:{uniforms:Nn([zt.sprite,zt.fog]),vertexShader:ge.sprite_vert,fragmentShader:ge.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ge.background_vert,fragmentShader:ge.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:ge.backgroundCube_vert,fragmentShader:ge.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ge.cube_vert,fragmentShader:ge.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ge.equirect_vert,fragmentShader:ge.equirect_frag},distance:{uniforms:Nn([zt.common,zt.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ge.distance_vert,fragmentShader:ge.distance_frag},shadow:{uniforms:Nn([zt.lights,zt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:ge.shadow_vert,fragmentShader:ge.shadow_frag}};Yi.physical={uniforms:Nn([Yi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new Kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new Kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new Kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag};var sh={r:0,b:0,g:0},wM=new ve,qg=new oe;qg.set(-1,0,0,0,1,0,0,0,1);function EM(i,t,e,n,s,r){let o=new ee(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(M){let C=M.isScene===!0?M.background:null;if(C&&C.isTexture){let v=M.backgroundBlurriness>0;C=t.get(C,v)}return C}function g(M){let C=!1,v=d(M);v===null?m(o,a):v&&v.isColor&&(m(v,1),C=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(M,C){let v=d(C);v&&v.isCubeTexture?(c===void 0&&(c=new _n(new Hi(1,1,1),new Wi({name:"BackgroundCubeMaterial",uniforms:lr(Yi.backgroundCube.uniforms),vertexShader:Yi.backgroundCube.vertexShader,fragmentShader:Yi.backgroundCube.fragmentShader,side:Xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(wM.makeRotationFromEuler(C.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(qg),c.material.toneMapped=we.getTransfer(v.colorSpace)!==De,(h!==v||u!==v.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=v,u=v.version,f=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new _n(new ua(2,2),new Wi({name:"BackgroundMaterial",uniforms:lr(Yi.background.uniforms),vertexShader:Yi.background.vertexShader,fragmentShader:Yi.background.fragmentShader,side:ks,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=we.getTransfer(v.colorSpace)!==De,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||u!==v.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=v,u=v.version,f=i.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function m(M,C){M.getRGB(sh,Tf(i)),e.buffers.color.setClear(sh.r,sh.g,sh.b,C,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,C=1){o.set(M),a=C,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,m(o,a)},render:g,addToRenderList:S,dispose:p}}function TM(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(L,V,X,D,H){let q=!1,G=u(L,D,X,V);r!==G&&(r=G,c(r.object)),q=d(L,D,X,H),q&&g(L,D,X,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,v(L,V,X,D),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,V,X,D){let H=D.wireframe===!0,q=n[V.id];q===void 0&&(q={},n[V.id]=q);let G=L.isInstancedMesh===!0?L.id:0,ct=q[G];ct===void 0&&(ct={},q[G]=ct);let Y=ct[X.id];Y===void 0&&(Y={},ct[X.id]=Y);let j=Y[H];return j===void 0&&(j=f(l()),Y[H]=j),j}function f(L){let V=[],X=[],D=[];for(let H=0;H<e;H++)V[H]=0,X[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:X,attributeDivisors:D,object:L,attributes:{},index:null}}function d(L,V,X,D){let H=r.attributes,q=V.attributes,G=0,ct=X.getAttributes();for(let Y in ct)if(ct[Y].location>=0){let it=H[Y],pt=q[Y];if(pt===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(pt=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(pt=L.instanceColor)),it===void 0||it.attribute!==pt||pt&&it.data!==pt.data)return!0;G++}return r.attributesNum!==G||r.index!==D}function g(L,V,X,D){let H={},q=V.attributes,G=0,ct=X.getAttributes();for(let Y in ct)if(ct[Y].location>=0){let it=q[Y];it===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(it=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(it=L.instanceColor));let pt={};pt.attribute=it,it&&it.data&&(pt.data=it.data),H[Y]=pt,G++}r.attributes=H,r.attributesNum=G,r.index=D}function S(){let L=r.newAttributes;for(let V=0,X=L.length;V<X;V++)L[V]=0}function m(L){p(L,0)}function p(L,V){let X=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;X[L]=1,D[L]===0&&(i.enableVertexAttribArray(L),D[L]=1),H[L]!==V&&(i.vertexAttribDivisor(L,V),H[L]=V)}function M(){let L=r.newAttributes,V=r.enabledAttributes;for(let X=0,D=V.length;X<D;X++)V[X]!==L[X]&&(i.disableVertexAttribArray(X),V[X]=0)}function C(L,V,X,D,H,q,G){G===!0?i.vertexAttribIPointer(L,V,X,H,q):i.vertexAttribPointer(L,V,X,D,H,q)}function v(L,V,X,D){S();let H=D.attributes,q=X.getAttributes(),G=V.defaultAttributeValues;for(let ct in q){let Y=q[ct];if(Y.location>=0){let j=H[ct];if(j===void 0&&(ct==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),ct==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){let it=j.normalized,pt=j.itemSize,ht=t.get(j);if(ht===void 0)continue;let tt=ht.buffer,gt=ht.type,Mt=ht.bytesPerElement,Lt=gt===i.INT||gt===i.UNSIGNED_INT||j.gpuType===yc;if(j.isInterleavedBufferAttribute){let At=j.data,jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,he=j.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Zt=0;Zt<Y.locationSize;Zt++)p(Y.location+Zt,At.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Zt=0;Zt<Y.locationSize;Zt++)m(Y.location+Zt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Zt=0;Zt<Y.locationSize;Zt++)C(Y.location+Zt,pt/Y.locationSize,gt,it,jt*Mt,(he+pt/Y.locationSize*Zt)*Mt,Lt)}else{if(j.isInstancedBufferAttribute){for(let At=0;At<Y.locationSize;At++)p(Y.location+At,j.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let At=0;At<Y.locationSize;At++)m(Y.location+At);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let At=0;At<Y.locationSize;At++)C(Y.location+At,pt/Y.locationSize,gt,it,pt*Mt,pt/Y.locationSize*At*Mt,Lt)}}else if(G!==void 0){let it=G[ct];if(it!==void 0)switch(it.length){case 2:i.vertexAttrib2fv(Y.location,it);break;case 3:i.vertexAttrib3fv(Y.location,it);break;case 4:i.vertexAttrib4fv(Y.location,it);break;default:i.vertexAttrib1fv(Y.location,it)}}}}M()}function R(){k();for(let L in n){let V=n[L];for(let X in V){let D=V[X];for(let H in D){let q=D[H];for(let G in q)h(q[G].object),delete q[G];delete D[H]}}delete n[L]}}function A(L){if(n[L.id]===void 0)return;let V=n[L.id];for(let X in V){let D=V[X];for(let H in D){let q=D[H];for(let G in q)h(q[G].object),delete q[G];delete D[H]}}delete n[L.id]}function y(L){for(let V in n){let X=n[V];for(let D in X){let H=X[D];if(H[L.id]===void 0)continue;let q=H[L.id];for(let G in q)h(q[G].object),delete q[G];delete H[L.id]}}}function T(L){for(let V in n){let X=n[V],D=L.isInstancedMesh===!0?L.id:0,H=X[D];if(H!==void 0){for(let q in H){let G=H[q];for(let ct in G)h(G[ct].object),delete G[ct];delete H[q]}delete X[D],Object.keys(X).length===0&&delete n[V]}}}function k(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:U,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:S,enableAttribute:m,disableUnusedAttributes:M}}function AM(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function CM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Pi&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let T=y===Ri&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==$n&&y!==Ci&&!T&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(se("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&se("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&se("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:g,maxTextureSize:S,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:M,maxVaryings:C,maxFragmentUniforms:v,maxSamples:R,samples:A}}function RM(i){let t=this,e=null,n=0,s=!1,r=!1,o=new ri,a=new oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let g=u.clippingPlanes,S=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let M=r?0:n,C=M*4,v=p.clippingState||null;l.value=v,v=h(g,f,C,d);for(let R=0;R!==C;++R)v[R]=e[R];p.clippingState=v,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,g){let S=u!==null?u.length:0,m=null;if(S!==0){if(m=l.value,g!==!0||m===null){let p=d+S*4,M=f.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<p)&&(m=new Float32Array(p));for(let C=0,v=d;C!==S;++C,v+=4)o.copy(u[C]).applyMatrix4(M,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,m}}var Pa=class extends ai{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new aa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Hi(5,5,5),r=new Wi({name:"CubemapFromEquirect",uniforms:lr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Xn,blending:sr});r.uniforms.tEquirect.value=e;let o=new _n(s,r),a=e.minFilter;return e.minFilter===ps&&(e.minFilter=Hn),new uo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},wg=256,PM=3,IM=20,Yg=256,$g=16,LM=3,DM=new O,NM=new ee,oh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new uo(1,10,null),this._boxMesh=new _n(new Hi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=DM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,S=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,S===null&&(t.background=l.getClearColor(NM));let m=new uo(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,t.background=S,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ag(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Tg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(wg,bf(t))}_fromTexture(t,e){t.mapping===or||t.mapping===_o?this._setSize(t.image.length===0?wg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Eg(t,!1,!1),n=Math.log2(t)-PM;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Eg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===or||t.mapping===_o?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ag()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Tg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=UM(),this._integrationMaterial=FM());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/$g);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-LM)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Yg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=OM());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Eg(i,t,e){return new Pa(i,{minFilter:ps,generateMipmaps:t,type:Ri,colorSpace:jo,depthBuffer:e})}function La(i,t,e){return new Wi({name:i,uniforms:t,vertexShader:ge.cube_vert,fragmentShader:e,side:Xn,blending:sr,depthTest:!1,depthWrite:!1})}function UM(){return La("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Yg}u

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
	`)}function FM(){return La("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:$g}},`

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
	`)}function OM(){return La("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${IM}
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
	`)}function Tg(){return La("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ag(){return La("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function BM(i){let t=new WeakMap,e=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===gc||d===_c)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let S=new Pa(g.height);return S.fromEquirectangularTexture(i,f),t.set(f,S),f.addEventListener("dispose",c),a(S.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===gc||d===_c,S=d===or||d===_o;if(g||S){let m=e.get(f),p=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new oh(i)),m=g?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),m.texture;if(m!==void 0)return m.texture;{let M=f.image;return g&&M&&M.height>0||S&&M&&l(M)?(n===null&&(n=new oh(i)),m=g?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,d){return d===gc?f.mapping=or:d===_c&&(f.mapping=_o),f}function l(f){let d=0,g=6;for(let S=0;S<g;S++)f[S]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function zM(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&$o("WebGLRenderer: "+n+" extension not supported."),s}}}function kM(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let S=r.get(g);S&&(t.remove(S),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,S){return s[S.id]!==void 0||(S.addEventListener("dispose",a),s[S.id]=new WeakRef(S),o.register(S,S.id,S),e.memory.geometries++),S}function h(g){let S=g.attributes;for(let m in S)t.update(S[m],i.ARRAY_BUFFER)}function u(g){let S=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let M=S!==null?S.array.length:m.array.length/3-1,C=m.count>=65535?ra:sa,v=new C(Math.ceil(M/3)*6,1),R=v.array;if(S!==null){let y=S.array;p=S.version;for(let T=0,k=0;T<M;T+=3){let U=y[T+0],L=y[T+1],V=y[T+2];R[k++]=U,R[k++]=L,R[k++]=L,R[k++]=V,R[k++]=V,R[k++]=U}}else{p=m.version;for(let y=0,T=0;y<M;y+=3){let k=y+0,U=y+1,L=y+2;R[T++]=k,R[T++]=U,R[T++]=U,R[T++]=L,R[T++]=L,R[T++]=k}}v.version=p;let A=r.get(g);A&&t.remove(A),r.set(g,v)}function f(g){let S=r.get(g);if(S){let m=g.index;m!==null&&S.version<m.version&&u(g)}else u(g);return r.get(g)}function d(){for(let g in s){let S=s[g].deref();S!==void 0&&l(S)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function VM(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),e.update(f,n,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let S=0;for(let m=0;m<d;m++)S+=f[m];e.update(S,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function GM(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ce("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function HM(i,t,e){let n=new WeakMap,s=new Ae;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let k=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",k)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,S=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],C=0;d===!0&&(C=1),g===!0&&(C=2),S===!0&&(C=3);let v=a.attributes.position.count*C,R=1;v>t.maxTextureSize&&(R=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*R*4*u),y=new na(A,v,R,u);y.type=Ci,y.needsUpdate=!0;let T=C*4;for(let U=0;U<u;U++){let L=m[U],V=p[U],X=M[U],D=v*R*4*U;for(let H=0;H<L.count;H++){let q=H*T;d===!0&&(s.fromBufferAttribute(L,H),A[D+q+0]=s.x,A[D+q+1]=s.y,A[D+q+2]=s.z,A[D+q+3]=0),g===!0&&(s.fromBufferAttribute(V,H),A[D+q+4]=s.x,A[D+q+5]=s.y,A[D+q+6]=s.z,A[D+q+7]=0),S===!0&&(s.fromBufferAttribute(X,H),A[D+q+8]=s.x,A[D+q+9]=s.y,A[D+q+10]=s.z,A[D+q+11]=X.itemSize===4?s.w:1)}}f={count:u,texture:y,size:new Kt(v,R)},n.set(a,f),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let S=0;S<c.length;S++)d+=c[S];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function WM(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var XM={[ef]:"LINEAR_TONE_MAPPING",[nf]:"REINHARD_TONE_MAPPING",[sf]:"CINEON_TONE_MAPPING",[rf]:"ACES_FILMIC_TONE_MAPPING",[af]:"AGX_TONE_MAPPING",[lf]:"NEUTRAL_TONE_MAPPING",[of]:"CUSTOM_TONE_MAPPING"};function qM(i,t,e,n,s,r){let o=new ai(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new rn;h.setAttribute("position",new Je([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Je([0,2,0,0,2,0],2));let u=new tc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new _n(h,u),d=new Os(-1,1,1,-1,0,1),g=null,S=null,m=!1,p,M=null,C=[],v=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),l!==null&&l.setSize(R,A);for(let y=0;y<C.length;y++){let T=C[y];T.setSize&&T.setSize(R,A)}},this.setEffects=function(R){C=R,v=C.length>0&&C[0].isRenderPass===!0;let A=o.width,y=o.height;C.length>0&&a===null&&(a=new ai(A,y,{type:Ri,depthBuffer:!1,stencilBuffer:!1}),l=new ai(A,y,{type:Ri,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&C.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new fs(A,y),r===!0&&(c.format=ms,c.type=ar)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<C.length;k++){let U=C[k];U.setSize&&U.setSize(A,y),T&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(R,A){if(m||R.toneMapping===Xi&&C.length===0)return!1;if(M=A,A!==null){let y=A.width,T=A.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return v===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=Xi,!0},this.hasRenderPass=function(){return v},this.end=function(R,A){R.toneMapping=p,m=!0;let y=o,T=a;for(let k=0;k<C.length;k++){let U=C[k];U.enabled!==!1&&(U.render(R,T,y,A),U.needsSwap!==!1&&(y=T,T=T===a?l:a))}if(g!==R.outputColorSpace||S!==R.toneMapping){g=R.outputColorSpace,S=R.toneMapping,u.defines={},we.getTransfer(g)===De&&(u.defines.SRGB_TRANSFER="");let k=XM[S];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(M),R.render(f,d),M=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Zg=new Wn,Jg=new fs(1,1),Kg=new ca(1),jg=new na,Qg=new $l,t0=new aa,Cg=[],Rg=[],Pg=new Float32Array(16),Ig=new Float32Array(9),Lg=new Float32Array(4);function vo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Cg[s];if(r===void 0&&(r=new Float32Array(s),Cg[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function xn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function yn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function ah(i,t){let e=Rg[t];e===void 0&&(e=new Int32Array(t),Rg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function YM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function $M(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(xn(e,t))return;i.uniform2fv(this.addr,t),yn(e,t)}}function ZM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(xn(e,t))return;i.uniform3fv(this.addr,t),yn(e,t)}}function JM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(xn(e,t))return;i.uniform4fv(this.addr,t),yn(e,t)}}function KM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(xn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),yn(e,t)}else{if(xn(e,n))return;Lg.set(n),i.uniformMatrix2fv(this.addr,!1,Lg),yn(e,n)}}function jM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(xn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),yn(e,t)}else{if(xn(e,n))return;Ig.set(n),i.uniformMatrix3fv(this.addr,!1,Ig),yn(e,n)}}function QM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(xn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),yn(e,t)}else{if(xn(e,n))return;Pg.set(n),i.uniformMatrix4fv(this.addr,!1,Pg),yn(e,n)}}function tb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function eb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(xn(e,t))return;i.uniform2iv(this.addr,t),yn(e,t)}}function nb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(xn(e,t))return;i.uniform3iv(this.addr,t),yn(e,t)}}function ib(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(xn(e,t))return;i.uniform4iv(this.addr,t),yn(e,t)}}function sb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function rb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(xn(e,t))return;i.uniform2uiv(this.addr,t),yn(e,t)}}function ob(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(xn(e,t))return;i.uniform3uiv(this.addr,t),yn(e,t)}}function ab(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(xn(e,t))return;i.uniform4uiv(this.addr,t),yn(e,t)}}function lh(i){return i.version===0&&(i.compareFunction=yf,i.needsUpdate=!0),i}function lb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=lh(Jg):r=Zg,e.setTexture2D(t||r,s)}function cb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Qg,s)}function hb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=lh(Kg):r=t0,e.setTextureCube(t||r,s)}function ub(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||jg,s)}function fb(i){switch(i){case 5126:return YM;case 35664:return $M;case 35665:return ZM;case 35666:return JM;case 35674:return KM;case 35675:return jM;case 35676:return QM;case 5124:case 35670:return tb;case 35667:case 35671:return eb;case 35668:case 35672:return nb;case 35669:case 35673:return ib;case 5125:return sb;case 36294:return rb;case 36295:return ob;case 36296:return ab;case 35678:case 36198:case 36298:case 36306:case 35682:return lb;case 35679:case 36299:case 36307:return cb;case 35680:case 36300:case 36308:case 36293:return hb;case 36289:case 36303:case 36311:case 36292:return ub}}function db(i,t){i.uniform1fv(this.addr,t)}function pb(i,t){let e=vo(t,this.size,2);i.uniform2fv(this.addr,e)}function mb(i,t){let e=vo(t,this.size,3);i.uniform3fv(this.addr,e)}function gb(i,t){let e=vo(t,this.size,4);i.uniform4fv(this.addr,e)}function _b(i,t){let e=vo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function xb(i,t){let e=vo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function yb(i,t){let e=vo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function vb(i,t){i.uniform1iv(this.addr,t)}function Sb(i,t){i.uniform2iv(this.addr,t)}function Mb(i,t){i.uniform3iv(this.addr,t)}function bb(i,t){i.uniform4iv(this.addr,t)}function wb(i,t){i.uniform1uiv(this.addr,t)}function Eb(i,t){i.uniform2uiv(this.addr,t)}function Tb(i,t){i.uniform3uiv(this.addr,t)}function Ab(i,t){i.uniform4uiv(this.addr,t)}function Cb(i,t,e){let n=this.cache,s=t.length,r=ah(e,s);xn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=lh(Jg):o=Zg;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Rb(i,t,e){let n=this.cache,s=t.length,r=ah(e,s);xn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Qg,r[o])}function Pb(i,t,e){let n=this.cache,s=t.length,r=ah(e,s);xn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=lh(Kg):o=t0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Ib(i,t,e){let n=this.cache,s=t.length,r=ah(e,s);xn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||jg,r[o])}function Lb(i){switch(i){case 5126:return db;case 35664:return pb;case 35665:return mb;case 35666:return gb;case 35674:return _b;case 35675:return xb;case 35676:return yb;case 5124:case 35670:return vb;case 35667:case 35671:return Sb;case 35668:case 35672:return Mb;case 35669:case 35673:return bb;case 5125:return wb;case 36294:return Eb;case 36295:return Tb;case 36296:return Ab;case 35678:case 36198:case 36298:case 36306:case 35682:return Cb;case 35679:case 36299:case 36307:return Rb;case 35680:case 36300:case 36308:case 36293:return Pb;case 36289:case 36303:case 36311:case 36292:return Ib}}var Lf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=fb(e.type)}},Df=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Lb(e.type)}},Nf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Pf=/(\w+)(\])?(\[|\.)?/g;function Dg(i,t){i.seq.push(t),i.map[t.id]=t}function Db(i,t,e){let n=i.name,s=n.length;for(Pf.lastIndex=0;;){let r=Pf.exec(n),o=Pf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Dg(e,c===void 0?new Lf(a,i,t):new Df(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Nf(a),Dg(e,u)),e=u}}}var yo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Db(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Ng(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Nb=37297,Ub=0;function Fb(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Ug=new oe;function Ob(i){we._getMatrix(Ug,we.workingColorSpace,i);let t=`mat3( ${Ug.elements.map(e=>e.toFixed(4))} )`;switch(we.getTransfer(i)){case Qo:return[t,"LinearTransferOETF"];case De:return[t,"sRGBTransferOETF"];default:return se("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Fg(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Fb(i.getShaderSource(t),a)}else return r}function Bb(i,t){let e=Ob(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var zb={[ef]:"Linear",[nf]:"Reinhard",[sf]:"Cineon",[rf]:"ACESFilmic",[af]:"AgX",[lf]:"Neutral",[of]:"Custom"};function kb(i,t){let e=zb[t];return e===void 0?(se("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var rh=new O;function Vb(){we.getLuminanceCoefficients(rh);let i=rh.x.toFixed(4),t=rh.y.toFixed(4),e=rh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Gb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ra).join(`
`)}function Hb(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Wb(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ra(i){return i!==""}function Og(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Bg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Xb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Uf(i){return i.replace(Xb,qb)}function qb(i,t){let e=ge[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Uf(e)}var Yb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function zg(i){return i.replace(Yb,$b)}function $b(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function kg(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var Zb={[va]:"SHADOWMAP_TYPE_PCF",[mo]:"SHADOWMAP_TYPE_VSM"};function Jb(i){return Zb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Kb={[_o]:"ENVMAP_MODE_REFRACTION"};function jb(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Kb[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Qb={[mc]:"ENVMAP_BLENDING_MULTIPLY",[sg]:"ENVMAP_BLENDING_MIX",[rg]:"ENVMAP_BLENDING_ADD"};function tw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Qb[i.combine]||"ENVMAP_BLENDING_NONE"}function ew(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Jb(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=jb(e),u=tw(e),f=Gb(e),d=Hb(r),g=s.createProgram(),S,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(S=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ra).join(`
`),S.length>0&&(S+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ra).join(`
`),m.length>0&&(m+=`
`)):(S=[kg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ra).join(`
`),m=[kg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Xi?"#define TONE_MAPPING":"",e.toneMapping!==Xi?ge.tonemapping_pars_fragment:"",e.toneMapping!==Xi?kb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ge.colorspace_pars_fragment,Bb("linearToOutputTexel",e.outputColorSpace),Vb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ra).join(`
`)),o=Uf(o),o=Og(o,e),o=Bg(o,e),a=Uf(a),a=Og(a,e),a=Bg(a,e),o=zg(o),a=zg(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,S=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,m=["#define varying in",e.glslVersion===Sf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Sf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let M=p+S+o,C=p+m+a,v=Ng(s,s.VERTEX_SHADER,M),R=Ng(s,s.FRAGMENT_SHADER,C);s.attachShader(g,v),s.attachShader(g,R),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(U){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",V=s.getShaderInfoLog(v)||"",X=s.getShaderInfoLog(R)||"",D=L.trim(),H=V.trim(),q=X.trim(),G=!0,ct=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,v,R);else{let Y=Fg(s,v,"vertex"),j=Fg(s,R,"fragment");ce("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+D+`
`+Y+`
`+j)}else D!==""?se("WebGLProgram: Program Info Log:",D):(H===""||q==="")&&(ct=!1);ct&&(U.diagnostics={runnable:G,programLog:D,vertexShader:{log:H,prefix:S},fragmentShader:{log:q,prefix:m}})}s.deleteShader(v),s.deleteShader(R),y=new yo(s,g),T=Wb(s,g)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let T;this.getAttributes=function(){return T===void 0&&A(this),T};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,Nb)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Ub++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=R,this}var nw=0,Ff=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Of(t),e.set(t,n)),n}},Of=class{constructor(t){this.id=nw++,this.code=t,this.usedTimes=0}};function iw(i){return i===Vs||i===Ta||i===Aa}function sw(i,t,e,n,s,r){let o=new ro,a=new Ff,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,T,k,U,L,V){let X=U.fog,D=L.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?U.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=t.get(y.envMap||H,q),ct=f[y.type],Y=n.precision;y.precision!==null&&(Y=n.getMaxPrecision(y.precision),Y!==y.precision&&se("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let j=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,it=j!==void 0?j.length:0,pt=0;D.morphAttributes.position!==void 0&&(pt=1),D.morphAttributes.normal!==void 0&&(pt=2),D.morphAttributes.color!==void 0&&(pt=3);let ht,tt,gt,Mt;if(ct){let Ct=Yi[ct];ht=Ct.vertexShader,tt=Ct.fragmentShader}else{ht=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),ae=a.getFragmentShaderStage(y);a.update(y,Ct,ae),gt=Ct.id,Mt=ae.id}let Lt=i.getRenderTarget(),At=i.state.buffers.depth.getReversed(),jt=L.isInstancedMesh===!0,he=L.isBatchedMesh===!0,Zt=!!y.map,fe=!!y.matcap,de=!!G,re=de&&G.isPMREMTexture===!0,Ne=!!y.aoMap,Ie=!!y.lightMap,Ge=!!y.bumpMap&&y.wireframe===!1,K=!!y.normalMap,ft=!!y.displacementMap,xt=!!y.emissiveMap,bt=!!y.metalnessMap,_t=!!y.roughnessMap,Yt=y.anisotropy>0,P=y.clearcoat>0,ut=y.diffuseRoughness>0,kt=y.dispersion>0,Ut=y.retroreflectivity>0,yt=y.iridescence>0,Xt=y.sheen>0,Et=y.transmission>0,Vt=Yt&&!!y.anisotropyMap,E=P&&!!y.clearcoatMap,x=P&&!!y.clearcoatNormalMap,B=P&&!!y.clearcoatRoughnessMap,st=ut&&!!y.diffuseRoughnessMap,Q=yt&&!!y.iridescenceMap,mt=yt&&!!y.iridescenceThicknessMap,vt=Xt&&!!y.sheenColorMap,et=Xt&&!!y.sheenRoughnessMap,rt=!!y.specularMap,St=!!y.specularColorMap,F=!!y.specularIntensityMap,at=Et&&!!y.transmissionMap,ot=Et&&!!y.thicknessMap,Pt=!!y.gradientMap,Tt=!!y.alphaMap,Rt=y.alphaTest>0,Qt=!!y.alphaHash,ie=!!y.extensions,lt=Xi;y.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(lt=i.toneMapping);let Ot=re?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,te={shaderID:ct,shaderType:y.type,shaderName:y.name,vertexShader:ht,fragmentShader:tt,defines:y.defines,customVertexShaderID:gt,customFragmentShaderID:Mt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:he,batchingColor:he&&L._colorsTexture!==null,instancing:jt,instancingColor:jt&&L.instanceColor!==null,instancingMorph:jt&&L.morphTexture!==null,outputColorSpace:Lt===null?i.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:we.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Zt,matcap:fe,envMap:de,envMapMode:de&&G.mapping,envMapPMREM:re,envMapMaxLod:re?Ot.length-1:null,envMapSize:re?Ot[0].width:null,aoMap:Ne,lightMap:Ie,bumpMap:Ge,normalMap:K,displacementMap:ft,emissiveMap:xt,normalMapObjectSpace:K&&y.normalMapType===lg,normalMapTangentSpace:K&&y.normalMapType===eh,packedNormalMap:K&&y.normalMapType===eh&&iw(y.normalMap.format),metalnessMap:bt,roughnessMap:_t,anisotropy:Yt,anisotropyMap:Vt,clearcoat:P,clearcoatMap:E,clearcoatNormalMap:x,clearcoatRoughnessMap:B,diffuseRoughness:ut,diffuseRoughnessMap:st,dispersion:kt,retroreflection:Ut,iridescence:yt,iridescenceMap:Q,iridescenceThicknessMap:mt,sheen:Xt,sheenColorMap:vt,sheenRoughnessMap:et,specularMap:rt,specularColorMap:St,specularIntensityMap:F,transmission:Et,transmissionMap:at,thicknessMap:ot,gradientMap:Pt,opaque:y.transparent===!1&&y.blending===go&&y.alphaToCoverage===!1,alphaMap:Tt,alphaTest:Rt,alphaHash:Qt,combine:y.combine,mapUv:Zt&&d(y.map.channel),aoMapUv:Ne&&d(y.aoMap.channel),lightMapUv:Ie&&d(y.lightMap.channel),bumpMapUv:Ge&&d(y.bumpMap.channel),normalMapUv:K&&d(y.normalMap.channel),displacementMapUv:ft&&d(y.displacementMap.channel),emissiveMapUv:xt&&d(y.emissiveMap.channel),metalnessMapUv:bt&&d(y.metalnessMap.channel),roughnessMapUv:_t&&d(y.roughnessMap.channel),anisotropyMapUv:Vt&&d(y.anisotropyMap.channel),clearcoatMapUv:E&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:x&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:st&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:mt&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&d(y.sheenRoughnessMap.channel),specularMapUv:rt&&d(y.specularMap.channel),specularColorMapUv:St&&d(y.specularColorMap.channel),specularIntensityMapUv:F&&d(y.specularIntensityMap.channel),transmissionMapUv:at&&d(y.transmissionMap.channel),thicknessMapUv:ot&&d(y.thicknessMap.channel),alphaMapUv:Tt&&d(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(K||Yt),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(Zt||Tt),fog:!!X,useFog:y.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&K===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:At,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:pt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:V.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:lt,decodeVideoTexture:Zt&&y.map.isVideoTexture===!0&&we.getTransfer(y.map.colorSpace)===De,decodeVideoTextureEmissive:xt&&y.emissiveMap.isVideoTexture===!0&&we.getTransfer(y.emissiveMap.colorSpace)===De,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===qn,flipSided:y.side===Xn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:ie&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ie&&y.extensions.multiDraw===!0||he)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function S(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let k in y.defines)T.push(k),T.push(y.defines[k]);return y.isRawShaderMaterial===!1&&(m(T,y),p(T,y),T.push(i.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}function m(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}function p(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function M(y){let T=f[y.type],k;if(T){let U=Yi[T];k=Sg.clone(U.uniforms)}else k=y.uniforms;return k}function C(y,T){let k=h.get(T);return k!==void 0?++k.usedTimes:(k=new ew(i,T,y,s),c.push(k),h.set(T,k)),k}function v(y){if(--y.usedTimes===0){let T=c.indexOf(y);c[T]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:S,getUniforms:M,acquireProgram:C,releaseProgram:v,releaseShaderCache:R,programs:c,dispose:A}}function rw(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function ow(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Vg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Gg(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,S,m,p){let M=i[t];return M===void 0?(M={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:S,renderOrder:f.renderOrder,z:m,group:p},i[t]=M):(M.id=f.id,M.object=f,M.geometry=d,M.material=g,M.materialVariant=o(f),M.groupOrder=S,M.renderOrder=f.renderOrder,M.z=m,M.group=p),t++,M}function l(f,d,g,S,m,p,M){M.reversedDepth===!0&&(m=-m);let C=a(f,d,g,S,m,p);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):e.push(C)}function c(f,d,g,S,m,p){let M=a(f,d,g,S,m,p);g.transmission>0?n.unshift(M):g.transparent===!0?s.unshift(M):e.unshift(M)}function h(f,d){e.length>1&&e.sort(f||ow),n.length>1&&n.sort(d||Vg),s.length>1&&s.sort(d||Vg)}function u(){for(let f=t,d=i.length;f<d;f++){let g=i[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function aw(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Gg,i.set(n,[o])):s>=r.length?(o=new Gg,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function lw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new O,color:new ee};break;case"SpotLight":e={position:new O,direction:new O,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new O,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new O,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new O,halfWidth:new O,halfHeight:new O};break}return i[t.id]=e,e}}}function cw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var hw=0;function uw(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function fw(i){let t=new lw,e=cw(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new O);let s=new O,r=new ve,o=new ve;function a(c){let h=0,u=0,f=0;for(let V=0;V<9;V++)n.probe[V].set(0,0,0);let d=0,g=0,S=0,m=0,p=0,M=0,C=0,v=0,R=0,A=0,y=0,T=0,k=0,U=0;c.sort(uw);for(let V=0,X=c.length;V<X;V++){let D=c[V],H=D.color,q=D.intensity,G=D.distance,ct=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Vs?ct=D.shadow.map.texture:ct=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=H.r*q,u+=H.g*q,f+=H.b*q;else if(D.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(D.sh.coefficients[Y],q);U++}else if(D.isSunLight){let Y=t.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,it=e.get(D);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=it,n.sunShadowMap[g]=ct;let pt=j.getViewportCount();for(let ht=0;ht<pt;ht++)n.sunShadowMatrix[S+ht]=j.getMatrix(ht),n.sunShadowCascade[S+ht]=j._cascadeData[ht];S+=pt,g++}n.sun[d]=Y,d++}else if(D.isDirectionalLight){let Y=t.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,it=e.get(D);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize=j.mapSize,n.directionalShadow[m]=it,n.directionalShadowMap[m]=ct,n.directionalShadowMatrix[m]=D.shadow.matrix,R++}n.directional[m]=Y,m++}else if(D.isSpotLight){let Y=t.get(D);Y.position.setFromMatrixPosition(D.matrixWorld),Y.color.copy(H).multiplyScalar(q),Y.distance=G,Y.coneCos=Math.cos(D.angle),Y.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Y.decay=D.decay,n.spot[M]=Y;let j=D.shadow;if(D.map&&(n.spotLightMap[T]=D.map,T++,j.updateMatrices(D),D.castShadow&&k++),n.spotLightMatrix[M]=j.matrix,D.castShadow){let it=e.get(D);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize=j.mapSize,n.spotShadow[M]=it,n.spotShadowMap[M]=ct,y++}M++}else if(D.isRectAreaLight){let Y=t.get(D);Y.color.copy(H).multiplyScalar(q),Y.halfWidth.set(D.width*.5,0,0),Y.halfHeight.set(0,D.height*.5,0),n.rectArea[C]=Y,C++}else if(D.isPointLight){let Y=t.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),Y.distance=D.distance,Y.decay=D.decay,D.castShadow){let j=D.shadow,it=e.get(D);it.shadowIntensity=j.intensity,it.shadowBias=j.bias,it.shadowNormalBias=j.normalBias,it.shadowRadius=j.radius,it.shadowMapSize=j.mapSize,it.shadowCameraNear=j.camera.near,it.shadowCameraFar=j.camera.far,n.pointShadow[p]=it,n.pointShadowMap[p]=ct,n.pointShadowMatrix[p]=D.shadow.matrix,A++}n.point[p]=Y,p++}else if(D.isHemisphereLight){let Y=t.get(D);Y.skyColor.copy(D.color).multiplyScalar(q),Y.groundColor.copy(D.groundColor).multiplyScalar(q),n.hemi[v]=Y,v++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=zt.LTC_FLOAT_1,n.rectAreaLTC2=zt.LTC_FLOAT_2):(n.rectAreaLTC1=zt.LTC_HALF_1,n.rectAreaLTC2=zt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let L=n.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==p||L.spotLength!==M||L.rectAreaLength!==C||L.hemiLength!==v||L.numSunShadows!==g||L.numDirectionalShadows!==R||L.numPointShadows!==A||L.numSpotShadows!==y||L.numSpotMaps!==T||L.numLightProbes!==U)&&(n.sun.length=d,n.directional.length=m,n.spot.length=M,n.rectArea.length=C,n.point.length=p,n.hemi.length=v,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+T-k,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=U,L.sunLength=d,L.directionalLength=m,L.pointLength=p,L.spotLength=M,L.rectAreaLength=C,L.hemiLength=v,L.numSunShadows=g,L.numDirectionalShadows=R,L.numPointShadows=A,L.numSpotShadows=y,L.numSpotMaps=T,L.numLightProbes=U,n.version=hw++)}function l(c,h){let u=0,f=0,d=0,g=0,S=0,m=0,p=h.matrixWorldInverse;for(let M=0,C=c.length;M<C;M++){let v=c[M];if(v.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(v.matrixWorld),R.direction.transformDirection(p),u++}else if(v.isDirectionalLight){let R=n.directional[f];R.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),f++}else if(v.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(v.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),g++}else if(v.isRectAreaLight){let R=n.rectArea[S];R.position.setFromMatrixPosition(v.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(v.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(v.width*.5,0,0),R.halfHeight.set(0,v.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),S++}else if(v.isPointLight){let R=n.point[d];R.position.setFromMatrixPosition(v.matrixWorld),R.position.applyMatrix4(p),d++}else if(v.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(v.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function Hg(i){let t=new fw(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function dw(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Hg(i),t.set(s,[a])):r>=o.length?(a=new Hg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var pw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,mw=`uniform sampler2D shadow_pass;
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
}`,gw=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],_w=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],Wg=new ve,Ca=new O,If=new O;function xw(i,t,e){let n=new Gi,s=new Kt,r=new Kt,o=new Ae,a=new ec,l=new nc,c={},h=e.maxTextureSize,u={[ks]:Xn,[Xn]:ks,[qn]:qn},f=new Wi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Kt},radius:{value:4}},vertexShader:pw,fragmentShader:mw}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new rn;g.setAttribute("position",new Tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new _n(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=va;let p=this.type;this.render=function(A,y,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===zm&&(se("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=va);let k=i.getRenderTarget(),U=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),V=i.state;V.setBlending(sr),V.buffers.depth.getReversed()===!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let X=p!==this.type;X&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=A.length;D<H;D++){let q=A[D],G=q.shadow;if(G===void 0){se("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ct=G.getFrameExtents();s.multiply(ct),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,G.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Y,G.map===null||X===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===mo){if(q.isPointLight){se("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new ai(s.x,s.y,{format:Vs,type:Ri,minFilter:Hn,magFilter:Hn,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new fs(s.x,s.y,Ci),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=ls,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=An,G.map.depthTexture.magFilter=An}else q.isPointLight?(G.map=new Pa(s.x),G.map.depthTexture=new ca(s.x,Ai)):(G.map=new ai(s.x,s.y),G.map.depthTexture=new fs(s.x,s.y,Ai)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=ls,this.type===va?(G.map.depthTexture.compareFunction=Y?xf:_f,G.map.depthTexture.minFilter=Hn,G.map.depthTexture.magFilter=Hn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=An,G.map.depthTexture.magFilter=An);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,T);let it=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let pt=0;pt<j;pt++){let ht=G.getCamera(pt);if(q.isPointLight){let tt=G.camera,gt=G.matrix,Mt=q.distance||tt.far;Mt!==tt.far&&(tt.far=Mt,tt.updateProjectionMatrix()),Ca.setFromMatrixPosition(q.matrixWorld),tt.position.copy(Ca),If.copy(tt.position),If.add(gw[pt]),tt.up.copy(_w[pt]),tt.lookAt(If),tt.updateMatrixWorld(),gt.makeTranslation(-Ca.x,-Ca.y,-Ca.z),Wg.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Wg,tt.coordinateSystem,tt.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,pt),i.clear();else{pt===0&&(i.setRenderTarget(G.map),i.clear());let tt=G.getViewport(pt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),V.viewport(o)}n=G.getFrustum(pt),v(y,T,ht,q,it,this.type)}G.isPointLightShadow!==!0&&this.type===mo&&M(G,T),G.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(k,U,L)};function M(A,y){let T=t.update(S);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new ai(s.x,s.y,{format:Vs,type:Ri}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(y,null,T,f,S,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(y,null,T,d,S,null)}function C(A,y,T,k){let U=null,L=T.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)U=L;else if(U=T.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let V=U.uuid,X=y.uuid,D=c[V];D===void 0&&(D={},c[V]=D);let H=D[X];H===void 0&&(H=U.clone(),D[X]=H,y.addEventListener("dispose",R)),U=H}if(U.visible=y.visible,U.wireframe=y.wireframe,k===mo?U.side=y.shadowSide!==null?y.shadowSide:y.side:U.side=y.shadowSide!==null?y.shadowSide:u[y.side],U.alphaMap=y.alphaMap,U.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,U.map=y.map,U.clipShadows=y.clipShadows,U.clippingPlanes=y.clippingPlanes,U.clipIntersection=y.clipIntersection,U.displacementMap=y.displacementMap,U.displacementScale=y.displacementScale,U.displacementBias=y.displacementBias,U.wireframeLinewidth=y.wireframeLinewidth,U.linewidth=y.linewidth,T.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let V=i.properties.get(U);V.light=T}return U}function v(A,y,T,k,U,L){if(A.visible===!1)return;if(A.layers.test(U)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===mo)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,A.matrixWorld);let D=t.update(A),H=A.material;if(Array.isArray(H)){let q=D.groups;for(let G=0,ct=q.length;G<ct;G++){let Y=q[G],j=H[Y.materialIndex];if(j&&j.visible){let it=C(A,j,k,L);A.onBeforeShadow(i,A,y,T,D,it,Y),i.renderBufferDirect(T,null,D,it,A,Y),A.onAfterShadow(i,A,y,T,D,it,Y)}}}else if(H.visible){let q=C(A,H,k,L);A.onBeforeShadow(i,A,y,T,D,q,null),i.renderBufferDirect(T,null,D,q,A,null),A.onAfterShadow(i,A,y,T,D,q,null)}}let X=A.children;for(let D=0,H=X.length;D<H;D++)v(X[D],y,T,k,U,L)}function R(A){A.target.removeEventListener("dispose",R);for(let T in c){let k=c[T],U=A.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function yw(i,t){function e(){let F=!1,at=new Ae,ot=null,Pt=new Ae(0,0,0,0);return{setMask:function(Tt){ot!==Tt&&!F&&(i.colorMask(Tt,Tt,Tt,Tt),ot=Tt)},setLocked:function(Tt){F=Tt},setClear:function(Tt,Rt,Qt,ie,lt){lt===!0&&(Tt*=ie,Rt*=ie,Qt*=ie),at.set(Tt,Rt,Qt,ie),Pt.equals(at)===!1&&(i.clearColor(Tt,Rt,Qt,ie),Pt.copy(at))},reset:function(){F=!1,ot=null,Pt.set(-1,0,0,0)}}}function n(){let F=!1,at=!1,ot=null,Pt=null,Tt=null;return{setReversed:function(Rt){if(at!==Rt){let Qt=t.get("EXT_clip_control");Rt?Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.ZERO_TO_ONE_EXT):Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.NEGATIVE_ONE_TO_ONE_EXT),at=Rt;let ie=Tt;Tt=null,this.setClear(ie)}},getReversed:function(){return at},setTest:function(Rt){Rt?At(i.DEPTH_TEST):jt(i.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!F&&(i.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(at&&(Rt=xg[Rt]),Pt!==Rt){switch(Rt){case Fl:i.depthFunc(i.NEVER);break;case Ol:i.depthFunc(i.ALWAYS);break;case Bl:i.depthFunc(i.LESS);break;case to:i.depthFunc(i.LEQUAL);break;case zl:i.depthFunc(i.EQUAL);break;case kl:i.depthFunc(i.GEQUAL);break;case Vl:i.depthFunc(i.GREATER);break;case Gl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Pt=Rt}},setLocked:function(Rt){F=Rt},setClear:function(Rt){Tt!==Rt&&(Tt=Rt,at&&(Rt=1-Rt),i.clearDepth(Rt))},reset:function(){F=!1,ot=null,Pt=null,Tt=null,at=!1}}}function s(){let F=!1,at=null,ot=null,Pt=null,Tt=null,Rt=null,Qt=null,ie=null,lt=null;return{setTest:function(Ot){F||(Ot?At(i.STENCIL_TEST):jt(i.STENCIL_TEST))},setMask:function(Ot){at!==Ot&&!F&&(i.stencilMask(Ot),at=Ot)},setFunc:function(Ot,te,Ct){(ot!==Ot||Pt!==te||Tt!==Ct)&&(i.stencilFunc(Ot,te,Ct),ot=Ot,Pt=te,Tt=Ct)},setOp:function(Ot,te,Ct){(Rt!==Ot||Qt!==te||ie!==Ct)&&(i.stencilOp(Ot,te,Ct),Rt=Ot,Qt=te,ie=Ct)},setLocked:function(Ot){F=Ot},setClear:function(Ot){lt!==Ot&&(i.clearStencil(Ot),lt=Ot)},reset:function(){F=!1,at=null,ot=null,Pt=null,Tt=null,Rt=null,Qt=null,ie=null,lt=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,g=[],S=null,m=!1,p=null,M=null,C=null,v=null,R=null,A=null,y=null,T=new ee(0,0,0),k=0,U=!1,L=null,V=null,X=null,D=null,H=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ct=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(Y)[1]),G=ct>=1):Y.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),G=ct>=2);let j=null,it={},pt=i.getParameter(i.SCISSOR_BOX),ht=i.getParameter(i.VIEWPORT),tt=new Ae().fromArray(pt),gt=new Ae().fromArray(ht);function Mt(F,at,ot,Pt){let Tt=new Uint8Array(4),Rt=i.createTexture();i.bindTexture(F,Rt),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qt=0;Qt<ot;Qt++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(at,0,i.RGBA,1,1,Pt,0,i.RGBA,i.UNSIGNED_BYTE,Tt):i.texImage2D(at+Qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Tt);return Rt}let Lt={};Lt[i.TEXTURE_2D]=Mt(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=Mt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=Mt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=Mt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(i.DEPTH_TEST),o.setFunc(to),Ge(!1),K(Zu),At(i.CULL_FACE),Ne(sr);function At(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function jt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function he(F,at){return f[F]!==at?(i.bindFramebuffer(F,at),f[F]=at,F===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=at),F===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=at),!0):!1}function Zt(F,at){let ot=g,Pt=!1;if(F){ot=d.get(at),ot===void 0&&(ot=[],d.set(at,ot));let Tt=F.textures;if(ot.length!==Tt.length||ot[0]!==i.COLOR_ATTACHMENT0){for(let Rt=0,Qt=Tt.length;Rt<Qt;Rt++)ot[Rt]=i.COLOR_ATTACHMENT0+Rt;ot.length=Tt.length,Pt=!0}}else ot[0]!==i.BACK&&(ot[0]=i.BACK,Pt=!0);Pt&&i.drawBuffers(ot)}function fe(F){return S!==F?(i.useProgram(F),S=F,!0):!1}let de={[rr]:i.FUNC_ADD,[Vm]:i.FUNC_SUBTRACT,[Gm]:i.FUNC_REVERSE_SUBTRACT};de[Hm]=i.MIN,de[Wm]=i.MAX;let re={[Xm]:i.ZERO,[qm]:i.ONE,[Ym]:i.SRC_COLOR,[Qu]:i.SRC_ALPHA,[Qm]:i.SRC_ALPHA_SATURATE,[Km]:i.DST_COLOR,[Zm]:i.DST_ALPHA,[$m]:i.ONE_MINUS_SRC_COLOR,[tf]:i.ONE_MINUS_SRC_ALPHA,[jm]:i.ONE_MINUS_DST_COLOR,[Jm]:i.ONE_MINUS_DST_ALPHA,[tg]:i.CONSTANT_COLOR,[eg]:i.ONE_MINUS_CONSTANT_COLOR,[ng]:i.CONSTANT_ALPHA,[ig]:i.ONE_MINUS_CONSTANT_ALPHA};function Ne(F,at,ot,Pt,Tt,Rt,Qt,ie,lt,Ot){if(F===sr){m===!0&&(jt(i.BLEND),m=!1);return}if(m===!1&&(At(i.BLEND),m=!0),F!==km){if(F!==p||Ot!==U){if((M!==rr||R!==rr)&&(i.blendEquation(i.FUNC_ADD),M=rr,R=rr),Ot)switch(F){case go:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ju:i.blendFunc(i.ONE,i.ONE);break;case Ku:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ju:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ce("WebGLState: Invalid blending: ",F);break}else switch(F){case go:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ju:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ku:ce("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ju:ce("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ce("WebGLState: Invalid blending: ",F);break}C=null,v=null,A=null,y=null,T.set(0,0,0),k=0,p=F,U=Ot}return}Tt=Tt||at,Rt=Rt||ot,Qt=Qt||Pt,(at!==M||Tt!==R)&&(i.blendEquationSeparate(de[at],de[Tt]),M=at,R=Tt),(ot!==C||Pt!==v||Rt!==A||Qt!==y)&&(i.blendFuncSeparate(re[ot],re[Pt],re[Rt],re[Qt]),C=ot,v=Pt,A=Rt,y=Qt),(ie.equals(T)===!1||lt!==k)&&(i.blendColor(ie.r,ie.g,ie.b,lt),T.copy(ie),k=lt),p=F,U=!1}function Ie(F,at){F.side===qn?jt(i.CULL_FACE):At(i.CULL_FACE);let ot=F.side===Xn;at&&(ot=!ot),Ge(ot),F.blending===go&&F.transparent===!1?Ne(sr):Ne(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Pt=F.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),xt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?At(i.SAMPLE_ALPHA_TO_COVERAGE):jt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ge(F){L!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),L=F)}function K(F){F!==Om?(At(i.CULL_FACE),F!==V&&(F===Zu?i.cullFace(i.BACK):F===Bm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):jt(i.CULL_FACE),V=F}function ft(F){F!==X&&(G&&i.lineWidth(F),X=F)}function xt(F,at,ot){F?(At(i.POLYGON_OFFSET_FILL),(D!==at||H!==ot)&&(D=at,H=ot,o.getReversed()&&(at=-at,ot=-ot),i.polygonOffset(at,ot))):jt(i.POLYGON_OFFSET_FILL)}function bt(F){F?At(i.SCISSOR_TEST):jt(i.SCISSOR_TEST)}function _t(F){F===void 0&&(F=i.TEXTURE0+q-1),j!==F&&(i.activeTexture(F),j=F)}function Yt(F,at,ot){ot===void 0&&(j===null?ot=i.TEXTURE0+q-1:ot=j);let Pt=it[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},it[ot]=Pt),(Pt.type!==F||Pt.texture!==at)&&(j!==ot&&(i.activeTexture(ot),j=ot),i.bindTexture(F,at||Lt[F]),Pt.type=F,Pt.texture=at)}function P(){let F=it[j];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function ut(){try{i.compressedTexImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function kt(){try{i.compressedTexImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function yt(){try{i.texSubImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function Xt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function Et(){try{i.compressedTexSubImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function Vt(){try{i.texStorage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function E(){try{i.texStorage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function x(){try{i.texImage2D(...arguments)}catch(F){ce("WebGLState:",F)}}function B(){try{i.texImage3D(...arguments)}catch(F){ce("WebGLState:",F)}}function st(F){return u[F]!==void 0?u[F]:i.getParameter(F)}function Q(F,at){u[F]!==at&&(i.pixelStorei(F,at),u[F]=at)}function mt(F){tt.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function vt(F){gt.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),gt.copy(F))}function et(F,at){let ot=c.get(at);ot===void 0&&(ot=new WeakMap,c.set(at,ot));let Pt=ot.get(F);Pt===void 0&&(Pt=i.getUniformBlockIndex(at,F.name),i.uniformBlockBinding(at,Pt,Pt),ot.set(F,Pt))}function rt(F,at,ot){let Tt=c.get(at).get(F);l[Tt]!==ot&&(i.bindBufferBase(i.UNIFORM_BUFFER,Tt,ot),l[Tt]=ot)}function St(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,it={},f={},l={},d=new WeakMap,g=[],S=null,m=!1,p=null,M=null,C=null,v=null,R=null,A=null,y=null,T=new ee(0,0,0),k=0,U=!1,L=null,V=null,X=null,D=null,H=null,tt.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:jt,bindFramebuffer:he,drawBuffers:Zt,useProgram:fe,setBlending:Ne,setMaterial:Ie,setFlipSided:Ge,setCullFace:K,setLineWidth:ft,setPolygonOffset:xt,setScissorTest:bt,activeTexture:_t,bindTexture:Yt,unbindTexture:P,compressedTexImage2D:ut,compressedTexImage3D:kt,texImage2D:x,texImage3D:B,pixelStorei:Q,getParameter:st,updateUBOMapping:et,uniformBlockBinding:rt,texStorage2D:Vt,texStorage3D:E,texSubImage2D:Ut,texSubImage3D:yt,compressedTexSubImage2D:Xt,compressedTexSubImage3D:Et,scissor:mt,viewport:vt,reset:St}}function vw(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Kt,h=new WeakMap,u=new Set,f,d=new WeakMap,g=new Set,S=new FinalizationRegistry(E=>g.delete(E)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(E,x){return m?new OffscreenCanvas(E,x):ta("canvas")}function M(E,x,B){let st=1,Q=Vt(E);if((Q.width>B||Q.height>B)&&(st=B/Math.max(Q.width,Q.height)),st<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let mt=Math.floor(st*Q.width),vt=Math.floor(st*Q.height);f===void 0&&(f=p(mt,vt));let et=x?p(mt,vt):f;return et.width=mt,et.height=vt,et.getContext("2d").drawImage(E,0,0,mt,vt),se("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+mt+"x"+vt+")."),et}else return"data"in E&&se("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),E;return E}function C(E){return E.generateMipmaps}function v(E){i.generateMipmap(E)}function R(E){return E.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?i.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(E,x,B,st,Q,mt=!1){if(E!==null){if(i[E]!==void 0)return i[E];se("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let vt;st&&(vt=t.get("EXT_texture_norm16"),vt||se("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=x;if(x===i.RED&&(B===i.FLOAT&&(et=i.R32F),B===i.HALF_FLOAT&&(et=i.R16F),B===i.UNSIGNED_BYTE&&(et=i.R8),B===i.UNSIGNED_SHORT&&vt&&(et=vt.R16_EXT),B===i.SHORT&&vt&&(et=vt.R16_SNORM_EXT)),x===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(et=i.R8UI),B===i.UNSIGNED_SHORT&&(et=i.R16UI),B===i.UNSIGNED_INT&&(et=i.R32UI),B===i.BYTE&&(et=i.R8I),B===i.SHORT&&(et=i.R16I),B===i.INT&&(et=i.R32I)),x===i.RG&&(B===i.FLOAT&&(et=i.RG32F),B===i.HALF_FLOAT&&(et=i.RG16F),B===i.UNSIGNED_BYTE&&(et=i.RG8),B===i.UNSIGNED_SHORT&&vt&&(et=vt.RG16_EXT),B===i.SHORT&&vt&&(et=vt.RG16_SNORM_EXT)),x===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(et=i.RG8UI),B===i.UNSIGNED_SHORT&&(et=i.RG16UI),B===i.UNSIGNED_INT&&(et=i.RG32UI),B===i.BYTE&&(et=i.RG8I),B===i.SHORT&&(et=i.RG16I),B===i.INT&&(et=i.RG32I)),x===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(et=i.RGB8UI),B===i.UNSIGNED_SHORT&&(et=i.RGB16UI),B===i.UNSIGNED_INT&&(et=i.RGB32UI),B===i.BYTE&&(et=i.RGB8I),B===i.SHORT&&(et=i.RGB16I),B===i.INT&&(et=i.RGB32I)),x===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),B===i.UNSIGNED_INT&&(et=i.RGBA32UI),B===i.BYTE&&(et=i.RGBA8I),B===i.SHORT&&(et=i.RGBA16I),B===i.INT&&(et=i.RGBA32I)),x===i.RGB&&(B===i.UNSIGNED_SHORT&&vt&&(et=vt.RGB16_EXT),B===i.SHORT&&vt&&(et=vt.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),x===i.RGBA){let rt=mt?Qo:we.getTransfer(Q);B===i.FLOAT&&(et=i.RGBA32F),B===i.HALF_FLOAT&&(et=i.RGBA16F),B===i.UNSIGNED_BYTE&&(et=rt===De?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&vt&&(et=vt.RGBA16_EXT),B===i.SHORT&&vt&&(et=vt.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(E,x){let B;return E?x===null||x===Ai||x===ar?B=i.DEPTH24_STENCIL8:x===Ci?B=i.DEPTH32F_STENCIL8:x===xo&&(B=i.DEPTH24_STENCIL8,se("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ai||x===ar?B=i.DEPTH_COMPONENT24:x===Ci?B=i.DEPTH_COMPONENT32F:x===xo&&(B=i.DEPTH_COMPONENT16),B}function T(E,x){return C(E)===!0||E.isFramebufferTexture&&E.minFilter!==An&&E.minFilter!==Hn?Math.log2(Math.max(x.width,x.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?x.mipmaps.length:1}function k(E){let x=new WeakRef(E);n.get(E).__ref=x,g.add(x),S.register(E,x,x)}function U(E){let x=n.get(E).__ref;x!==void 0&&(g.delete(x),S.unregister(x))}function L(E){X(E.target)}function V(E){D(E.target)}function X(E){E.removeEventListener("dispose",L),U(E),q(E),E.isVideoTexture&&h.delete(E),E.isHTMLTexture&&u.delete(E)}function D(E){E.removeEventListener("dispose",V),U(E),ct(E)}function H(){for(let E of g){let x=E.deref();x!==void 0&&(x.isRenderTarget===!0?D(x):X(x))}g.clear(),u.clear()}function q(E){let x=n.get(E);if(x.__webglInit===void 0)return;let B=E.source,st=d.get(B);if(st){let Q=st[x.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&G(E),Object.keys(st).length===0&&d.delete(B)}n.remove(E)}function G(E){let x=n.get(E);i.deleteTexture(x.__webglTexture);let B=E.source,st=d.get(B);delete st[x.__cacheKey],o.memory.textures--}function ct(E){let x=n.get(E);x.__depthDisposeCallback&&x.__depthDisposeCallback();let B=E.depthTexture;if(B&&B.renderTarget===E&&X(B),E.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(x.__webglFramebuffer[Q]))for(let mt=0;mt<x.__webglFramebuffer[Q].length;mt++)i.deleteFramebuffer(x.__webglFramebuffer[Q][mt]);else i.deleteFramebuffer(x.__webglFramebuffer[Q]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[Q])}else{if(Array.isArray(x.__webglFramebuffer))for(let Q=0;Q<x.__webglFramebuffer.length;Q++)i.deleteFramebuffer(x.__webglFramebuffer[Q]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let Q=0;Q<x.__webglColorRenderbuffer.length;Q++)x.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[Q]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let st=E.textures;for(let Q=0,mt=st.length;Q<mt;Q++){let vt=n.get(st[Q]);vt.__webglTexture&&(i.deleteTexture(vt.__webglTexture),o.memory.textures--),n.remove(st[Q])}n.remove(E)}let Y=0;function j(){Y=0}function it(){return Y}function pt(E){Y=E}function ht(){let E=Y;return E>=s.maxTextures&&se("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,E}function tt(E){let x=[];return x.push(E.wrapS),x.push(E.wrapT),x.push(E.wrapR||0),x.push(E.magFilter),x.push(E.minFilter),x.push(E.anisotropy),x.push(E.internalFormat),x.push(E.format),x.push(E.type),x.push(E.generateMipmaps),x.push(E.mipmapsAutoUpdate),x.push(E.premultiplyAlpha),x.push(E.flipY),x.push(E.unpackAlignment),x.push(E.colorSpace),x.join()}function gt(E,x){let B=n.get(E);if(E.isVideoTexture&&Xt(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&B.__version!==E.version){let st=E.image;if(st===null)se("WebGLRenderer: Texture marked for update but no image data found.");else if(st.complete===!1)se("WebGLRenderer: Texture marked for update but image is incomplete");else{Ie(B,E,x);return}}else E.isExternalTexture&&(B.__webglTexture=E.sourceTexture?E.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+x)}function Mt(E,x){let B=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&B.__version!==E.version){Ie(B,E,x);return}else E.isExternalTexture&&(B.__webglTexture=E.sourceTexture?E.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+x)}function Lt(E,x){let B=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&B.__version!==E.version){Ie(B,E,x);return}e.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+x)}function At(E,x){let B=n.get(E);if(E.version>0&&B.__version!==E.version){Ge(B,E,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+x)}let jt={[Hl]:i.REPEAT,[ki]:i.CLAMP_TO_EDGE,[Wl]:i.MIRRORED_REPEAT},he={[An]:i.NEAREST,[og]:i.NEAREST_MIPMAP_NEAREST,[Sa]:i.NEAREST_MIPMAP_LINEAR,[Hn]:i.LINEAR,[xc]:i.LINEAR_MIPMAP_NEAREST,[ps]:i.LINEAR_MIPMAP_LINEAR},Zt={[hg]:i.NEVER,[yf]:i.ALWAYS,[ug]:i.LESS,[_f]:i.LEQUAL,[fg]:i.EQUAL,[xf]:i.GEQUAL,[dg]:i.GREATER,[pg]:i.NOTEQUAL};function fe(E,x){if(x.type===Ci&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===Hn||x.magFilter===xc||x.magFilter===Sa||x.magFilter===ps||x.minFilter===Hn||x.minFilter===xc||x.minFilter===Sa||x.minFilter===ps)&&se("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(E,i.TEXTURE_WRAP_S,jt[x.wrapS]),i.texParameteri(E,i.TEXTURE_WRAP_T,jt[x.wrapT]),(E===i.TEXTURE_3D||E===i.TEXTURE_2D_ARRAY)&&i.texParameteri(E,i.TEXTURE_WRAP_R,jt[x.wrapR]),i.texParameteri(E,i.TEXTURE_MAG_FILTER,he[x.magFilter]),i.texParameteri(E,i.TEXTURE_MIN_FILTER,he[x.minFilter]),x.compareFunction&&(i.texParameteri(E,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(E,i.TEXTURE_COMPARE_FUNC,Zt[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===An||x.minFilter!==Sa&&x.minFilter!==ps||x.type===Ci&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let B=t.get("EXT_texture_filter_anisotropic");i.texParameterf(E,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function de(E,x){let B=!1;E.__webglInit===void 0&&(E.__webglInit=!0,x.addEventListener("dispose",L),k(x));let st=x.source,Q=d.get(st);Q===void 0&&(Q={},d.set(st,Q));let mt=tt(x);if(mt!==E.__cacheKey){Q[mt]===void 0&&(Q[mt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,B=!0),Q[mt].usedTimes++;let vt=Q[E.__cacheKey];vt!==void 0&&(Q[E.__cacheKey].usedTimes--,vt.usedTimes===0&&G(x)),E.__cacheKey=mt,E.__webglTexture=Q[mt].texture}return B}function re(E,x,B){return Math.floor(Math.floor(E/B)/x)}function Ne(E,x,B,st){let mt=E.updateRanges;if(mt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,B,st,x.data);else{mt.sort((F,at)=>F.start-at.start);let vt=0;for(let F=1;F<mt.length;F++){let at=mt[vt],ot=mt[F],Pt=at.start+at.count,Tt=re(ot.start,x.width,4),Rt=re(at.start,x.width,4);ot.start<=Pt+1&&Tt===Rt&&re(ot.start+ot.count-1,x.width,4)===Tt?at.count=Math.max(at.count,ot.start+ot.count-at.start):(++vt,mt[vt]=ot)}mt.length=vt+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),rt=e.getParameter(i.UNPACK_SKIP_PIXELS),St=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let F=0,at=mt.length;F<at;F++){let ot=mt[F],Pt=Math.floor(ot.start/4),Tt=Math.ceil(ot.count/4),Rt=Pt%x.width,Qt=Math.floor(Pt/x.width),ie=Tt,lt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Qt),e.texSubImage2D(i.TEXTURE_2D,0,Rt,Qt,ie,lt,B,st,x.data)}E.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,St)}}function Ie(E,x,B){let st=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(st=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(st=i.TEXTURE_3D);let Q=de(E,x),mt=x.source;e.bindTexture(st,E.__webglTexture,i.TEXTURE0+B);let vt=n.get(mt);if(mt.version!==vt.__version||Q===!0){if(e.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&x.image instanceof ImageBitmap)===!1){let lt=we.getPrimaries(we.workingColorSpace),Ot=x.colorSpace===gs?null:we.getPrimaries(x.colorSpace),te=x.colorSpace===gs||lt===Ot?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment);let rt=M(x.image,!1,s.maxTextureSize);rt=Et(x,rt);let St=r.convert(x.format,x.colorSpace),F=r.convert(x.type),at=A(x.internalFormat,St,F,x.normalized,x.colorSpace,x.isVideoTexture);fe(st,x);let ot,Pt=x.mipmaps,Tt=x.isVideoTexture!==!0,Rt=vt.__version===void 0||Q===!0,Qt=mt.dataReady,ie=T(x,rt);if(x.isDepthTexture)at=y(x.format===ms,x.type),Rt&&(Tt?e.texStorage2D(i.TEXTURE_2D,1,at,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,at,rt.width,rt.height,0,St,F,null));else if(x.isDataTexture)if(Pt.length>0){Tt&&Rt&&e.texStorage2D(i.TEXTURE_2D,ie,at,Pt[0].width,Pt[0].height);for(let lt=0,Ot=Pt.length;lt<Ot;lt++)ot=Pt[lt],Tt?Qt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,ot.width,ot.height,St,F,ot.data):e.texImage2D(i.TEXTURE_2D,lt,at,ot.width,ot.height,0,St,F,ot.data);x.generateMipmaps=!1}else Tt?(Rt&&e.texStorage2D(i.TEXTURE_2D,ie,at,rt.width,rt.height),Qt&&Ne(x,rt,St,F)):e.texImage2D(i.TEXTURE_2D,0,at,rt.width,rt.height,0,St,F,rt.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){Tt&&Rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ie,at,Pt[0].width,Pt[0].height,rt.depth);for(let lt=0,Ot=Pt.length;lt<Ot;lt++)if(ot=Pt[lt],x.format!==Pi)if(St!==null)if(Tt){if(Qt)if(x.layerUpdates.size>0){let te=Rf(ot.width,ot.height,x.format,x.type);for(let Ct of x.layerUpdates){let ae=ot.data.subarray(Ct*te/ot.data.BYTES_PER_ELEMENT,(Ct+1)*te/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,Ct,ot.width,ot.height,1,St,ae)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,ot.width,ot.height,rt.depth,St,ot.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,lt,at,ot.width,ot.height,rt.depth,0,ot.data,0,0);else se("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Tt?Qt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,ot.width,ot.height,rt.depth,St,F,ot.data):e.texImage3D(i.TEXTURE_2D_ARRAY,lt,at,ot.width,ot.height,rt.depth,0,St,F,ot.data);x.layerUpdates.size>0&&x.clearLayerUpdates()}else{Tt&&Rt&&e.texStorage2D(i.TEXTURE_2D,ie,at,Pt[0].width,Pt[0].height);for(let lt=0,Ot=Pt.length;lt<Ot;lt++)ot=Pt[lt],x.format!==Pi?St!==null?Tt?Qt&&e.compressedTexSubImage2D(i.TEXTURE_2D,lt,0,0,ot.width,ot.height,St,ot.data):e.compressedTexImage2D(i.TEXTURE_2D,lt,at,ot.width,ot.height,0,ot.data):se("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Tt?Qt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,ot.width,ot.height,St,F,ot.data):e.texImage2D(i.TEXTURE_2D,lt,at,ot.width,ot.height,0,St,F,ot.data)}else if(x.isDataArrayTexture)if(Tt){if(Rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ie,at,rt.width,rt.height,rt.depth),Qt)if(x.layerUpdates.size>0){let lt=Rf(rt.width,rt.height,x.format,x.type);for(let Ot of x.layerUpdates){let te=rt.data.subarray(Ot*lt/rt.data.BYTES_PER_ELEMENT,(Ot+1)*lt/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ot,rt.width,rt.height,1,St,F,te)}x.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,St,F,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,at,rt.width,rt.height,rt.depth,0,St,F,rt.data);else if(x.isData3DTexture)Tt?(Rt&&e.texStorage3D(i.TEXTURE_3D,ie,at,rt.width,rt.height,rt.depth),Qt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,St,F,rt.data)):e.texImage3D(i.TEXTURE_3D,0,at,rt.width,rt.height,rt.depth,0,St,F,rt.data);else if(x.isFramebufferTexture){if(Rt)if(Tt)e.texStorage2D(i.TEXTURE_2D,ie,at,rt.width,rt.height);else{let lt=rt.width,Ot=rt.height;for(let te=0;te<ie;te++)e.texImage2D(i.TEXTURE_2D,te,at,lt,Ot,0,St,F,null),lt>>=1,Ot>>=1}}else if(x.isHTMLTexture){if("texElementImage2D"in i){let lt=i.canvas;if(lt.hasAttribute("layoutsubtree")||lt.setAttribute("layoutsubtree","true"),rt.parentNode!==lt){lt.appendChild(rt),u.add(x),lt.onpaint=Ot=>{let te=Ot.changedElements;for(let Ct of u)te.includes(Ct.image)&&(Ct.needsUpdate=!0)},lt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,rt);else{let te=i.RGBA,Ct=i.RGBA,ae=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,te,Ct,ae,rt)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Tt&&Rt){let lt=Vt(Pt[0]);e.texStorage2D(i.TEXTURE_2D,ie,at,lt.width,lt.height)}for(let lt=0,Ot=Pt.length;lt<Ot;lt++)ot=Pt[lt],Tt?Qt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,St,F,ot):e.texImage2D(i.TEXTURE_2D,lt,at,St,F,ot);x.generateMipmaps=!1}else if(Tt){if(Rt){let lt=Vt(rt);e.texStorage2D(i.TEXTURE_2D,ie,at,lt.width,lt.height)}Qt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,St,F,rt)}else e.texImage2D(i.TEXTURE_2D,0,at,St,F,rt);C(x)&&x.mipmapsAutoUpdate===!0&&v(st),vt.__version=mt.version,x.onUpdate&&x.onUpdate(x)}E.__version=x.version}function Ge(E,x,B){if(x.image.length!==6)return;let st=de(E,x),Q=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,E.__webglTexture,i.TEXTURE0+B);let mt=n.get(Q);if(Q.version!==mt.__version||st===!0){e.activeTexture(i.TEXTURE0+B);let vt=we.getPrimaries(we.workingColorSpace),et=x.colorSpace===gs?null:we.getPrimaries(x.colorSpace),rt=x.colorSpace===gs||vt===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let St=x.isCompressedTexture||x.image[0].isCompressedTexture,F=x.image[0]&&x.image[0].isDataTexture,at=[];for(let Ct=0;Ct<6;Ct++)!St&&!F?at[Ct]=M(x.image[Ct],!0,s.maxCubemapSize):at[Ct]=F?x.image[Ct].image:x.image[Ct],at[Ct]=Et(x,at[Ct]);let ot=at[0],Pt=r.convert(x.format,x.colorSpace),Tt=r.convert(x.type),Rt=A(x.internalFormat,Pt,Tt,x.normalized,x.colorSpace),Qt=x.isVideoTexture!==!0,ie=mt.__version===void 0||st===!0,lt=Q.dataReady,Ot=T(x,ot);fe(i.TEXTURE_CUBE_MAP,x);let te;if(x.isDepthTexture){if(Rt=y(x.format===ms,x.type),ie)if(Qt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Rt,ot.width,ot.height,0,Pt,Tt,null)}else if(St){Qt&&ie&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,Rt,ot.width,ot.height);for(let Ct=0;Ct<6;Ct++){te=at[Ct].mipmaps;for(let ae=0;ae<te.length;ae++){let Be=te[ae];x.format!==Pi?Pt!==null?Qt?lt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,Be.width,Be.height,Pt,Be.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,Rt,Be.width,Be.height,0,Be.data):se("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,Be.width,Be.height,Pt,Tt,Be.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,Rt,Be.width,Be.height,0,Pt,Tt,Be.data)}}}else{if(te=x.mipmaps,Qt&&ie){te.length>0&&Ot++;let Ct=Vt(at[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,Rt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(F){Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,at[Ct].width,at[Ct].height,Pt,Tt,at[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Rt,at[Ct].width,at[Ct].height,0,Pt,Tt,at[Ct].data);for(let ae=0;ae<te.length;ae++){let Rn=te[ae].image[Ct].image;Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,Rn.width,Rn.height,Pt,Tt,Rn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,Rt,Rn.width,Rn.height,0,Pt,Tt,Rn.data)}}else{Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Pt,Tt,at[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Rt,Pt,Tt,at[Ct]);for(let ae=0;ae<te.length;ae++){let Be=te[ae];Qt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,Pt,Tt,Be.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,Rt,Pt,Tt,Be.image[Ct])}}}C(x)&&x.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),mt.__version=Q.version,x.onUpdate&&x.onUpdate(x)}E.__version=x.version}function K(E,x,B,st,Q,mt){let vt=r.convert(B.format,B.colorSpace),et=r.convert(B.type),rt=A(B.internalFormat,vt,et,B.normalized,B.colorSpace),St=n.get(x),F=n.get(B);if(F.__renderTarget=x,!St.__hasExternalTextures){let at=Math.max(1,x.width>>mt),ot=Math.max(1,x.height>>mt);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?e.texImage3D(Q,mt,rt,at,ot,x.depth,0,vt,et,null):e.texImage2D(Q,mt,rt,at,ot,0,vt,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,E),yt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,st,Q,F.__webglTexture,0,Ut(x)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,st,Q,F.__webglTexture,mt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ft(E,x,B){if(i.bindRenderbuffer(i.RENDERBUFFER,E),x.depthBuffer){let st=x.depthTexture,Q=st&&st.isDepthTexture?st.type:null,mt=y(x.stencilBuffer,Q),vt=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;yt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(x),mt,x.width,x.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(x),mt,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,mt,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,vt,i.RENDERBUFFER,E)}else{let st=x.textures;for(let Q=0;Q<st.length;Q++){let mt=st[Q],vt=r.convert(mt.format,mt.colorSpace),et=r.convert(mt.type),rt=A(mt.internalFormat,vt,et,mt.normalized,mt.colorSpace);yt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(x),rt,x.width,x.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(x),rt,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,rt,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(E,x,B){let st=x.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,E),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(x.depthTexture);Q.__renderTarget=x;let mt=st?x.depthTexture.image[0]:x.depthTexture.image;(!Q.__webglTexture||mt.width!==x.width||mt.height!==x.height)&&(mt.width=x.width,mt.height=x.height,x.depthTexture.needsUpdate=!0),st?At(x.depthTexture,0):gt(x.depthTexture,0);let vt=Q.__webglTexture,et=Ut(x),rt=st?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,St=x.depthTexture.format===ms?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(x.depthTexture.format===ls)yt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,St,rt,vt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,St,rt,vt,0);else if(x.depthTexture.format===ms)yt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,St,rt,vt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,St,rt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function bt(E){let x=n.get(E),B=E.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==E.depthTexture){let st=E.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),st){let Q=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,st.removeEventListener("dispose",Q)};st.addEventListener("dispose",Q),x.__depthDisposeCallback=Q}x.__boundDepthTexture=st}if(E.depthTexture&&!x.__autoAllocateDepthBuffer)if(B)for(let st=0;st<6;st++)xt(x.__webglFramebuffer[st],E,st);else E.texture.mipmaps.length>0?xt(x.__webglFramebuffer[0],E,0):xt(x.__webglFramebuffer,E,0);else if(B){x.__webglDepthbuffer=[];for(let st=0;st<6;st++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[st]),x.__webglDepthbuffer[st]===void 0)x.__webglDepthbuffer[st]=i.createRenderbuffer(),ft(x.__webglDepthbuffer[st],E,!1);else{let Q=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,mt=x.__webglDepthbuffer[st];i.bindRenderbuffer(i.RENDERBUFFER,mt),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,mt)}}else if(E.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),ft(x.__webglDepthbuffer,E,!1);else{let Q=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,mt=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,mt),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,mt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function _t(E,x,B){let st=n.get(E);x!==void 0&&K(st.__webglFramebuffer,E,E.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&bt(E)}function Yt(E){let x=E.texture,B=n.get(E),st=n.get(x);E.addEventListener("dispose",V),k(E);let Q=E.textures,mt=E.isWebGLCubeRenderTarget===!0,vt=Q.length>1;if(vt||(st.__webglTexture===void 0&&(st.__webglTexture=i.createTexture()),st.__version=x.version,o.memory.textures++),mt){B.__webglFramebuffer=[];for(let et=0;et<6;et++)if(x.mipmaps.length>0){B.__webglFramebuffer[et]=[];for(let rt=0;rt<x.mipmaps.length;rt++)B.__webglFramebuffer[et][rt]=i.createFramebuffer()}else B.__webglFramebuffer[et]=i.createFramebuffer()}else{if(x.mipmaps.length>0){B.__webglFramebuffer=[];for(let et=0;et<x.mipmaps.length;et++)B.__webglFramebuffer[et]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(vt)for(let et=0,rt=Q.length;et<rt;et++){let St=n.get(Q[et]);St.__webglTexture===void 0&&(St.__webglTexture=i.createTexture(),o.memory.textures++)}if(E.samples>0&&yt(E)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let et=0;et<Q.length;et++){let rt=Q[et];B.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[et]);let St=r.convert(rt.format,rt.colorSpace),F=r.convert(rt.type),at=A(rt.internalFormat,St,F,rt.normalized,rt.colorSpace,E.isXRRenderTarget===!0),ot=Ut(E);i.renderbufferStorageMultisample(i.RENDERBUFFER,ot,at,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,B.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),E.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),ft(B.__webglDepthRenderbuffer,E,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(mt){e.bindTexture(i.TEXTURE_CUBE_MAP,st.__webglTexture),fe(i.TEXTURE_CUBE_MAP,x);for(let et=0;et<6;et++)if(x.mipmaps.length>0)for(let rt=0;rt<x.mipmaps.length;rt++)K(B.__webglFramebuffer[et][rt],E,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,rt);else K(B.__webglFramebuffer[et],E,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);C(x)?v(i.TEXTURE_CUBE_MAP):x.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let et=0,rt=Q.length;et<rt;et++){let St=Q[et],F=n.get(St),at=i.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(at=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(at,F.__webglTexture),fe(at,St),K(B.__webglFramebuffer,E,St,i.COLOR_ATTACHMENT0+et,at,0),C(St)&&v(at)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(et=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,st.__webglTexture),fe(et,x),x.mipmaps.length>0)for(let rt=0;rt<x.mipmaps.length;rt++)K(B.__webglFramebuffer[rt],E,x,i.COLOR_ATTACHMENT0,et,rt);else K(B.__webglFramebuffer,E,x,i.COLOR_ATTACHMENT0,et,0);C(x)?v(et):x.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),e.unbindTexture()}E.depthBuffer&&bt(E)}function P(E){let x=E.textures;for(let B=0,st=x.length;B<st;B++){let Q=x[B];if(C(Q)&&Q.mipmapsAutoUpdate===!0){let mt=R(E),vt=n.get(Q).__webglTexture;e.bindTexture(mt,vt),v(mt),e.unbindTexture()}}}let ut=[];function kt(E){if(E.samples>0){if(yt(E)===!1){let x=E.textures,B=E.width,st=E.height,Q=i.COLOR_BUFFER_BIT,mt=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=n.get(E),et=x.length>1;if(et)for(let St=0;St<x.length;St++)e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let St=0;St<x.length;St++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,vt.__webglColorRenderbuffer[St]);let F=n.get(x[St]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,B,st,0,0,B,st,Q,i.NEAREST),l===!0&&(ut.length=0,ut.push(i.COLOR_ATTACHMENT0+St),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&ut.push(mt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ut))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let St=0;St<x.length;St++){e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.RENDERBUFFER,vt.__webglColorRenderbuffer[St]);let F=n.get(x[St]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+St,i.TEXTURE_2D,F,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&l){let x=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function Ut(E){return Math.min(s.maxSamples,E.samples)}function yt(E){let x=n.get(E);return E.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Xt(E){let x=o.render.frame;h.get(E)!==x&&(h.set(E,x),E.update())}function Et(E,x){let B=E.colorSpace,st=E.format,Q=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||B!==jo&&B!==gs&&(we.getTransfer(B)===De?(st!==Pi||Q!==$n)&&se("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ce("WebGLTextures: Unsupported texture color space:",B)),x}function Vt(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=ht,this.resetTextureUnits=j,this.getTextureUnits=it,this.setTextureUnits=pt,this.setTexture2D=gt,this.setTexture2DArray=Mt,this.setTexture3D=Lt,this.setTextureCube=At,this.rebindTextures=_t,this.setupRenderTarget=Yt,this.updateRenderTargetMipmap=P,this.updateMultisampleRenderTarget=kt,this.setupDepthRenderbuffer=bt,this.setupFrameBufferTexture=K,this.useMultisampledRTT=yt,this.dispose=H}function Sw(i,t){function e(n,s=gs){let r,o=we.getTransfer(s);if(n===$n)return i.UNSIGNED_BYTE;if(n===vc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Sc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===ff)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===df)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===hf)return i.BYTE;if(n===uf)return i.SHORT;if(n===xo)return i.UNSIGNED_SHORT;if(n===yc)return i.INT;if(n===Ai)return i.UNSIGNED_INT;if(n===Ci)return i.FLOAT;if(n===Ri)return i.HALF_FLOAT;if(n===pf)return i.ALPHA;if(n===mf)return i.RGB;if(n===Pi)return i.RGBA;if(n===ls)return i.DEPTH_COMPONENT;if(n===ms)return i.DEPTH_STENCIL;if(n===gf)return i.RED;if(n===Mc)return i.RED_INTEGER;if(n===Vs)return i.RG;if(n===bc)return i.RG_INTEGER;if(n===wc)return i.RGBA_INTEGER;if(n===Ma||n===ba||n===wa||n===Ea)if(o===De)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ma)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ma)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ba)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===wa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ea)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ec||n===Tc||n===Ac||n===Cc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ec)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Tc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ac)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Cc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Rc||n===Pc||n===Ic||n===Lc||n===Dc||n===Ta||n===Nc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Rc||n===Pc)return o===De?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Ic)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Lc)return r.COMPRESSED_R11_EAC;if(n===Dc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ta)return r.COMPRESSED_RG11_EAC;if(n===Nc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Uc||n===Fc||n===Oc||n===Bc||n===zc||n===kc||n===Vc||n===Gc||n===Hc||n===Wc||n===Xc||n===qc||n===Yc||n===$c)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Uc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Fc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Oc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Bc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===zc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===kc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Vc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Gc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Hc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Wc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Xc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===qc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Yc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===$c)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Zc||n===Jc||n===Kc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Zc)return o===De?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Jc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Kc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===jc||n===Qc||n===Aa||n===th)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===jc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Qc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Aa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===th)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===ar?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Mw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,bw=`
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

}`,Bf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ha(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Wi({vertexShader:Mw,fragmentShader:bw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new _n(new ua(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},zf=class extends Ti{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,g=null,S=typeof XRWebGLBinding<"u",m=new Bf,p={},M=e.getContextAttributes(),C=null,v=null,R=[],A=[],y=new Kt,T=null,k=null,U=new Gn;U.viewport=new Ae;let L=new Gn;L.viewport=new Ae;let V=[U,L],X=new pc,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=R[tt];return gt===void 0&&(gt=new oo,R[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=R[tt];return gt===void 0&&(gt=new oo,R[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=R[tt];return gt===void 0&&(gt=new oo,R[tt]=gt),gt.getHandSpace()};function q(tt){let gt=A.indexOf(tt.inputSource);if(gt===-1)return;let Mt=R[gt];Mt!==void 0&&(Mt.update(tt.inputSource,tt.frame,c||o),Mt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function G(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<R.length;tt++){let gt=A[tt];gt!==null&&(A[tt]=null,R[tt].disconnect(gt))}D=null,H=null,m.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(C),d=null,f=null,u=null,s=null,v=null,ht.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(y.width,y.height,!1),k!==null){let tt=k.camera;tt.fov=k.fov,tt.zoom=k.zoom,tt.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&se("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&se("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&S&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(C=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ct),M.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(y),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let Mt=null,Lt=null,At=null;M.depth&&(At=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Mt=M.stencil?ms:ls,Lt=M.stencil?ar:Ai);let jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(jt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),v=new ai(f.textureWidth,f.textureHeight,{format:Pi,type:$n,depthTexture:new fs(f.textureWidth,f.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,Mt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let Mt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,Mt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new ai(d.framebufferWidth,d.framebufferHeight,{format:Pi,type:$n,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ht.setContext(s),ht.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(tt){for(let gt=0;gt<tt.removed.length;gt++){let Mt=tt.removed[gt],Lt=A.indexOf(Mt);Lt>=0&&(A[Lt]=null,R[Lt].disconnect(Mt))}for(let gt=0;gt<tt.added.length;gt++){let Mt=tt.added[gt],Lt=A.indexOf(Mt);if(Lt===-1){for(let jt=0;jt<R.length;jt++)if(jt>=A.length){A.push(Mt),Lt=jt;break}else if(A[jt]===null){A[jt]=Mt,Lt=jt;break}if(Lt===-1)break}let At=R[Lt];At&&At.connect(Mt)}}function Y(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,Mt=tt.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(Mt=m.depthFar)),X.near=L.near=U.near=gt,X.far=L.far=U.far=Mt,(D!==X.near||H!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),D=X.near,H=X.far),X.layers.mask=tt.layers.mask|6,U.layers.mask=X.layers.mask&-5,L.layers.mask=X.layers.mask&-3;let Lt=tt.parent,At=X.cameras;Y(X,Lt);for(let jt=0;jt<At.length;jt++)Y(At[jt],Lt);X.projectionMatrix.copy(U.projectionMatrix),X.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&tt.isPerspectiveCamera&&(k={camera:tt,fov:tt.fov,zoom:tt.zoom}),j(tt,X,Lt)};function j(tt,gt,Mt){Mt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(Mt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=io*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(tt){l=tt,f!==null&&(f.fixedFoveation=tt),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(X)},this.getCameraTexture=function(tt){return p[tt]};let it=null;function pt(tt,gt){if(h=gt.getViewerPose(c||o),g=gt,h!==null){let Mt=h.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let Lt=!1;Mt.length!==X.cameras.length&&(X.cameras.length=0,Lt=!0);for(let Zt=0;Zt<Mt.length;Zt++){let fe=Mt[Zt],de=null;if(d!==null)de=d.getViewport(fe);else{let Ne=u.getViewSubImage(f,fe);de=Ne.viewport,Zt===0&&(t.setRenderTargetTextures(v,Ne.colorTexture,Ne.depthStencilTexture),t.setRenderTarget(v))}let re=V[Zt];re===void 0&&(re=new Gn,re.layers.enable(Zt),re.viewport=new Ae,V[Zt]=re),re.matrix.fromArray(fe.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(fe.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(de.x,de.y,de.width,de.height),Zt===0&&(X.matrix.copy(re.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Lt===!0&&X.cameras.push(re)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){u=n.getBinding();let Zt=u.getDepthInformation(Mt[0]);Zt&&Zt.isValid&&Zt.texture&&m.init(Zt,s.renderState)}if(At&&At.includes("camera-access")&&S){t.state.unbindTexture(),u=n.getBinding();for(let Zt=0;Zt<Mt.length;Zt++){let fe=Mt[Zt].camera;if(fe){let de=p[fe];de||(de=new ha,p[fe]=de);let re=u.getCameraImage(fe);de.sourceTexture=re}}}}for(let Mt=0;Mt<R.length;Mt++){let Lt=A[Mt],At=R[Mt];Lt!==null&&At!==void 0&&At.update(Lt,gt,c||o)}it&&it(tt,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),g=null}let ht=new Xg;ht.setAnimationLoop(pt),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},ww=new ve,e0=new oe;e0.set(-1,0,0,0,1,0,0,0,1);function Ew(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Tf(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,M,C,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,v)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),S(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,M,C):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Xn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Xn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let M=t.get(p),C=M.envMap,v=M.envMapRotation;C&&(m.envMap.value=C,m.envMapRotation.value.setFromMatrix4(ww.makeRotationFromEuler(v)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(e0),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,M,C){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*M,m.scale.value=C*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,M){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Xn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function S(m,p){let M=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Tw(i,t,e,n){let s={},r={};function o(M,C){let v=C.program;n.uniformBlockBinding(M,v,s[M.id])}function a(M,C){let v=s[M.id];v===void 0&&(g(M),v=l(M),s[M.id]=v,M.addEventListener("dispose",m));let R=C.program;n.updateUBOMapping(M,R);let A=t.render.frame;r[M.id]!==A&&(c(M),r[M.id]=A)}function l(M){let C=i.createBuffer(),v=M.__size,R=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,v,R),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(M){let C=s[M.id],v=M.uniforms,R=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let A=0,y=v.length;A<y;A++){let T=v[A];if(Array.isArray(T))for(let k=0,U=T.length;k<U;k++)h(T[k],A,k,R);else h(T,A,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(M,C,v,R){if(f(M,C,v,R)===!0){let A=M.__offset,y=M.value;if(Array.isArray(y)){let T=0;for(let k=0;k<y.length;k++){let U=y[k],L=S(U,!0);u(U,M.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,M.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,M.__data)}}function u(M,C,v){typeof M=="number"||typeof M=="boolean"?C[v]=M:M.isMatrix3?(C[v]=M.elements[0],C[v+1]=M.elements[1],C[v+2]=M.elements[2],C[v+3]=0,C[v+4]=M.elements[3],C[v+5]=M.elements[4],C[v+6]=M.elements[5],C[v+7]=0,C[v+8]=M.elements[6],C[v+9]=M.elements[7],C[v+10]=M.elements[8],C[v+11]=0):ArrayBuffer.isView(M)?C.set(M.subarray(0,C.length-v),v):M.toArray(C,v)}function f(M,C,v,R){let A=M.value,y=C+"_"+v;if(Array.isArray(A)){R[y]===void 0&&(R[y]=[]);let T=R[y],k=!1;for(let U=0;U<A.length;U++)d(A[U],T,U)===!0&&(k=!0);return k}return d(A,R,y)}function d(M,C,v){if(C[v]===void 0)return typeof M=="number"||typeof M=="boolean"?C[v]=M:ArrayBuffer.isView(M)?C[v]=M.slice():C[v]=M.clone(),!0;{let R=C[v];if(typeof M=="number"||typeof M=="boolean"){if(R!==M)return C[v]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(R.equals(M)===!1)return R.copy(M),!0}}return!1}function g(M){let C=M.uniforms,v=0,R=16;for(let y=0,T=C.length;y<T;y++){let k=Array.isArray(C[y])?C[y]:[C[y]];for(let U=0,L=k.length;U<L;U++){let V=k[U],X=Array.isArray(V.value)?V.value:[V.value],D=Array.isArray(C[y])||Array.isArray(V.value),H=v;for(let G=0,ct=X.length;G<ct;G++){let Y=X[G],j=S(Y,D),it=v%R,pt=it%j.boundary,ht=it+pt;v+=pt,ht!==0&&R-ht<j.storage&&(v+=R-ht),G===0&&(H=v),v+=j.storage}let q=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;V.__data=new q((v-H)/Float32Array.BYTES_PER_ELEMENT),V.__offset=H}}let A=v%R;return A>0&&(v+=R-A),M.__size=v,M.__cache={},this}function S(M,C){let v={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(v.boundary=4,v.storage=4):M.isVector2?(v.boundary=8,v.storage=8):M.isVector3||M.isColor?(v.boundary=16,v.storage=12):M.isVector4?(v.boundary=16,v.storage=16):M.isMatrix3?(v.boundary=16,v.storage=48):M.isMatrix4?(v.boundary=16,v.storage=64):M.isTexture?se("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(v.boundary=16,v.storage=M.byteLength):se("WebGLRenderer: Unsupported uniform value type.",M),C===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(M){let C=M.target;C.removeEventListener("dispose",m),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function p(){for(let M in s)i.deleteBuffer(s[M]);s={},r={}}return{bind:o,update:a,dispose:p}}var Aw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),qi=null;function Cw(){return qi===null&&(qi=new Jl(Aw,16,16,Vs,Ri),qi.name="DFG_LUT",qi.minFilter=Hn,qi.magFilter=Hn,qi.wrapS=ki,qi.wrapT=ki,qi.generateMipmaps=!1,qi.needsUpdate=!0),qi}var Ia=class{constructor(t={}){let{canvas:e=mg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=$n}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let S=d,m=new Set([wc,bc,Mc]),p=new Set([$n,Ai,xo,ar,vc,Sc]),M=new Uint32Array(4),C=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},R=null,A=null,y=[],T=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Xi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,L=!1,V=null,X=null,D=null,H=null;this._outputColorSpace=Vn;let q=0,G=0,ct=null,Y=-1,j=null,it=new Ae,pt=new Ae,ht=null,tt=new ee(0),gt=0,Mt=e.width,Lt=e.height,At=1,jt=null,he=null,Zt=new Ae(0,0,Mt,Lt),fe=new Ae(0,0,Mt,Lt),de=!1,re=new Gi,Ne=new Kl,Ie=!1,Ge=!1,K=new ve,ft=new O,xt=new Ae,bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_t=!1;function Yt(){return ct===null?At:1}let P=n;function ut(w,z){return e.getContext(w,z)}let kt,Ut,yt,Xt,Et,Vt,E,x,B,st,Q,mt,vt,et,rt,St,F,at,ot,Pt,Tt,Rt,Qt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),P===null){let z="webgl2";if(P=ut(z,w),P===null)throw ut(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ie()}catch(w){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ce("WebGLRenderer: "+w.message),w}function ie(){kt=new zM(P),kt.init(),Tt=new Sw(P,kt),Ut=new CM(P,kt,t,Tt),yt=new yw(P,kt),Ut.reversedDepthBuffer&&f&&yt.buffers.depth.setReversed(!0),X=P.createFramebuffer(),D=P.createFramebuffer(),H=P.createFramebuffer(),Xt=new GM(P),Et=new rw,Vt=new vw(P,kt,yt,Et,Ut,Tt,Xt),E=new BM(U),x=new Wy(P),Rt=new TM(P,x),B=new kM(P,x,Xt,Rt),st=new WM(P,B,x,Rt,Xt),at=new HM(P,Ut,Vt),rt=new RM(Et),Q=new sw(U,E,kt,Ut,Rt,rt),mt=new Ew(U,Et),vt=new aw,et=new dw(kt),F=new EM(U,E,yt,st,g,l),St=new xw(U,st,Ut),Qt=new Tw(P,Xt,Ut,yt),ot=new AM(P,kt,Xt),Pt=new VM(P,kt,Xt),Xt.programs=Q.programs,U.capabilities=Ut,U.extensions=kt,U.properties=Et,U.renderLists=vt,U.shadowMap=St,U.state=yt,U.info=Xt}S!==$n&&(k=new qM(S,e.width,e.height,a,s,r));let lt=new zf(U,P);this.xr=lt,this.getContext=function(){return P},this.getContextAttributes=function(){return P.getContextAttributes()},this.forceContextLoss=function(){let w=kt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=kt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(w){w!==void 0&&(At=w,this.setSize(Mt,Lt,!1))},this.getSize=function(w){return w.set(Mt,Lt)},this.setSize=function(w,z,nt=!0){if(lt.isPresenting){se("WebGLRenderer: Can't change size while VR device is presenting.");return}Mt=w,Lt=z,e.width=Math.floor(w*At),e.height=Math.floor(z*At),nt===!0&&(e.style.width=w+"px",e.style.height=z+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,z)},this.getDrawingBufferSize=function(w){return w.set(Mt*At,Lt*At).floor()},this.setDrawingBufferSize=function(w,z,nt){Mt=w,Lt=z,At=nt,e.width=Math.floor(w*nt),e.height=Math.floor(z*nt),this.setViewport(0,0,w,z)},this.setEffects=function(w){if(S===$n){ce("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let z=0;z<w.length;z++)if(w[z].isOutputPass===!0){se("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(it)},this.getViewport=function(w){return w.copy(Zt)},this.setViewport=function(w,z,nt,$){w.isVector4?Zt.set(w.x,w.y,w.z,w.w):Zt.set(w,z,nt,$),yt.viewport(it.copy(Zt).multiplyScalar(Yt()).round())},this.getScissor=function(w){return w.copy(fe)},this.setScissor=function(w,z,nt,$){w.isVector4?fe.set(w.x,w.y,w.z,w.w):fe.set(w,z,nt,$),yt.scissor(pt.copy(fe).multiplyScalar(Yt()).round())},this.getScissorTest=function(){return de},this.setScissorTest=function(w){yt.setScissorTest(de=w)},this.setOpaqueSort=function(w){jt=w},this.setTransparentSort=function(w){he=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,z=!0,nt=!0){let $=0;if(w){let Z=!1;if(ct!==null){let Dt=ct.texture.format;Z=m.has(Dt)}if(Z){let Dt=ct.texture.type,Ft=p.has(Dt),Nt=F.getClearColor(),Bt=F.getClearAlpha(),Jt=Nt.r,ue=Nt.g,_e=Nt.b;Ft?(M[0]=Jt,M[1]=ue,M[2]=_e,M[3]=Bt,P.clearBufferuiv(P.COLOR,0,M)):(C[0]=Jt,C[1]=ue,C[2]=_e,C[3]=Bt,P.clearBufferiv(P.COLOR,0,C))}else $|=P.COLOR_BUFFER_BIT}z&&($|=P.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&($|=P.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&P.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),V=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),F.dispose(),vt.dispose(),et.dispose(),Vt.dispose(),Et.dispose(),E.dispose(),st.dispose(),B.dispose(),Rt.dispose(),Qt.dispose(),Q.dispose(),lt.dispose(),lt.removeEventListener("sessionstart",za),lt.removeEventListener("sessionend",Ii),$i.stop()};function Ot(w){w.preventDefault(),ea("WebGLRenderer: Context Lost."),L=!0}function te(){ea("WebGLRenderer: Context Restored."),L=!1;let w=Xt.autoReset,z=St.enabled,nt=St.autoUpdate,$=St.needsUpdate,Z=St.type;ie(),Xt.autoReset=w,St.enabled=z,St.autoUpdate=nt,St.needsUpdate=$,St.type=Z}function Ct(w){ce("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function ae(w){let z=w.target;z.removeEventListener("dispose",ae),Be(z)}function Be(w){Rn(w),Et.remove(w)}function Rn(w){let z=Et.get(w).programs;z!==void 0&&(z.forEach(function(nt){Q.releaseProgram(nt)}),w.isShaderMaterial&&Q.releaseShaderCache(w))}this.renderBufferDirect=function(w,z,nt,$,Z,Dt){z===null&&(z=bt);let Ft=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Nt=Eo(w,z,nt,$,Z);yt.setMaterial($,Ft);let Bt=nt.index,Jt=1;if($.wireframe===!0){if(Bt=B.getWireframeAttribute(nt),Bt===void 0)return;Jt=2}let ue=nt.drawRange,_e=nt.attributes.position,$t=ue.start*Jt,xe=(ue.start+ue.count)*Jt;Dt!==null&&($t=Math.max($t,Dt.start*Jt),xe=Math.min(xe,(Dt.start+Dt.count)*Jt)),Bt!==null?($t=Math.max($t,0),xe=Math.min(xe,Bt.count)):_e!=null&&($t=Math.max($t,0),xe=Math.min(xe,_e.count));let Ze=xe-$t;if(Ze<0||Ze===1/0)return;Rt.setup(Z,$,Nt,nt,Bt);let Ue,Fe=ot;if(Bt!==null&&(Ue=x.get(Bt),Fe=Pt,Fe.setIndex(Ue)),Z.isMesh)$.wireframe===!0?(yt.setLineWidth($.wireframeLinewidth*Yt()),Fe.setMode(P.LINES)):Fe.setMode(P.TRIANGLES);else if(Z.isLine){let fn=$.linewidth;fn===void 0&&(fn=1),yt.setLineWidth(fn*Yt()),Z.isLineSegments?Fe.setMode(P.LINES):Z.isLineLoop?Fe.setMode(P.LINE_LOOP):Fe.setMode(P.LINE_STRIP)}else Z.isPoints?Fe.setMode(P.POINTS):Z.isSprite&&Fe.setMode(P.TRIANGLES);if(Z.isBatchedMesh)if(kt.get("WEBGL_multi_draw"))Fe.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let fn=Z._multiDrawStarts,Wt=Z._multiDrawCounts,on=Z._multiDrawCount,Me=Bt?x.get(Bt).bytesPerElement:1,Ji=Et.get($).currentProgram.getUniforms();for(let an=0;an<on;an++)Ji.setValue(P,"_gl_DrawID",an),Fe.render(fn[an]/Me,Wt[an])}else if(Z.isInstancedMesh)Fe.renderInstances($t,Ze,Z.count);else if(nt.isInstancedBufferGeometry){let fn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Wt=Math.min(nt.instanceCount,fn);Fe.renderInstances($t,Ze,Wt)}else Fe.render($t,Ze)};function Mo(w,z,nt,$){V!==null&&w.isNodeMaterial&&V.setObject($,w),Ie===!0&&rt.setState(w,nt,!1),w.transparent===!0&&w.side===qn&&w.forceSinglePass===!1?(w.side=Xn,w.needsUpdate=!0,Li(w,z,$),w.side=ks,w.needsUpdate=!0,Li(w,z,$),w.side=qn):Li(w,z,$)}this.compile=function(w,z,nt=null){nt===null&&(nt=w),V!==null&&V.renderStart(w,z,nt),A=et.get(nt),A.init(z),T.push(A),nt.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),w!==nt&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),V!==null&&V.updateLights(A.state.lightsArray),Ge=this.localClippingEnabled,Ie=rt.init(this.clippingPlanes,Ge),Ie===!0&&rt.setGlobalState(this.clippingPlanes,z),V!==null&&St.render(A.state.shadowsArray,nt,z);let $=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Dt=Z.material;if(Dt)if(Array.isArray(Dt))for(let Ft=0;Ft<Dt.length;Ft++){let Nt=Dt[Ft];Mo(Nt,nt,z,Z),$.add(Nt)}else Mo(Dt,nt,z,Z),$.add(Dt)}),A=T.pop(),V!==null&&V.renderEnd(),$},this.compileAsync=function(w,z,nt=null){let $=this.compile(w,z,nt);return new Promise(Z=>{function Dt(){if($.forEach(function(Ft){let Bt=Et.get(Ft).currentProgram;(Bt===void 0||Bt.isReady())&&$.delete(Ft)}),$.size===0){Z(w);return}setTimeout(Dt,10)}kt.get("KHR_parallel_shader_compile")!==null?Dt():setTimeout(Dt,10)})};let hr=null;function Rh(w){hr&&hr(w)}function za(){$i.stop()}function Ii(){$i.start()}let $i=new Xg;$i.setAnimationLoop(Rh),typeof self<"u"&&$i.setContext(self),this.setAnimationLoop=function(w){hr=w,lt.setAnimationLoop(w),w===null?$i.stop():$i.start()},lt.addEventListener("sessionstart",za),lt.addEventListener("sessionend",Ii),this.render=function(w,z){if(z!==void 0&&z.isCamera!==!0){ce("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;V!==null&&V.renderStart(w,z);let nt=lt.enabled===!0&&lt.isPresenting===!0,$=k!==null&&(ct===null||nt)&&k.begin(U,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),lt.enabled===!0&&lt.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(lt.cameraAutoUpdate===!0&&lt.updateCamera(z),z=lt.getCamera()),w.isScene===!0&&w.onBeforeRender(U,w,z,ct),A=et.get(w,T.length),A.init(z),A.state.textureUnits=Vt.getTextureUnits(),T.push(A),K.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Ne.setFromArrayCamera(z):re.setFromProjectionMatrix(K,mi,z.reversedDepth),Ge=this.localClippingEnabled,Ie=rt.init(this.clippingPlanes,Ge),R=vt.get(w,y.length),R.init(),y.push(R),this.info.render.frame++,lt.enabled===!0&&lt.isPresenting===!0){let Ft=U.xr.getDepthSensingMesh();Ft!==null&&Zi(Ft,z,-1/0,U.sortObjects)}Zi(w,z,0,U.sortObjects),R.finish(),V!==null&&V.updateLights(A.state.lightsArray),U.sortObjects===!0&&R.sort(jt,he),_t=lt.enabled===!1||lt.isPresenting===!1||lt.hasDepthSensing()===!1,_t&&F.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Ie===!0&&rt.beginShadows();let Z=A.state.shadowsArray;if(St.render(Z,w,z),Ie===!0&&rt.endShadows(),($&&k.hasRenderPass())===!1){let Ft=R.opaque,Nt=R.transmissive;if(A.setupLights(),z.isArrayCamera){let Bt=z.cameras;if(Nt.length>0)for(let Jt=0,ue=Bt.length;Jt<ue;Jt++){let _e=Bt[Jt];_i(Ft,Nt,w,_e)}_t&&F.render(w);for(let Jt=0,ue=Bt.length;Jt<ue;Jt++){let _e=Bt[Jt];bo(R,w,_e,_e.viewport)}}else Nt.length>0&&_i(Ft,Nt,w,z),_t&&F.render(w),bo(R,w,z)}ct!==null&&G===0&&(Vt.updateMultisampleRenderTarget(ct),Vt.updateRenderTargetMipmap(ct)),$&&k.end(U),w.isScene===!0&&w.onAfterRender(U,w,z),Rt.resetDefaultState(),Y=-1,j=null,T.pop(),T.length>0?(A=T[T.length-1],Vt.setTextureUnits(A.state.textureUnits),Ie===!0&&rt.setGlobalState(U.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,V!==null&&V.renderEnd()};function Zi(w,z,nt,$){if(w.visible===!1)return;if(w.layers.test(z.layers)){if(w.isGroup)nt=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(z);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Ft=z.isArrayCamera?Ne:re;if(!w.frustumCulled||w.intersectsFrustum(Ft)){$&&xt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(K);let Nt=st.update(w),Bt=w.material;Bt.visible&&R.push(w,Nt,Bt,nt,xt.z,null,z)}}else if(w.isMesh||w.isLine||w.isPoints){let Ft=z.isArrayCamera?Ne:re;if(!w.frustumCulled||w.intersectsFrustum(Ft)){let Nt=st.update(w),Bt=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xt.copy(w.boundingSphere.center)):(Nt.boundingSphere===null&&Nt.computeBoundingSphere(),xt.copy(Nt.boundingSphere.center)),xt.applyMatrix4(w.matrixWorld).applyMatrix4(K)),Array.isArray(Bt)){let Jt=Nt.groups;for(let ue=0,_e=Jt.length;ue<_e;ue++){let $t=Jt[ue],xe=Bt[$t.materialIndex];xe&&xe.visible&&R.push(w,Nt,xe,nt,xt.z,$t,z)}}else Bt.visible&&R.push(w,Nt,Bt,nt,xt.z,null,z)}}}let Dt=w.children;for(let Ft=0,Nt=Dt.length;Ft<Nt;Ft++)Zi(Dt[Ft],z,nt,$)}function bo(w,z,nt,$){let{opaque:Z,transmissive:Dt,transparent:Ft}=w;A.setupLightsView(nt),Ie===!0&&rt.setGlobalState(U.clippingPlanes,nt),$&&yt.viewport(it.copy($)),Z.length>0&&je(Z,z,nt),Dt.length>0&&je(Dt,z,nt),Ft.length>0&&je(Ft,z,nt),yt.buffers.depth.setTest(!0),yt.buffers.depth.setMask(!0),yt.buffers.color.setMask(!0),yt.setPolygonOffset(!1)}function _i(w,z,nt,$){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let $t=kt.has("EXT_color_buffer_half_float")||kt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new ai(1,1,{generateMipmaps:!0,type:$t?Ri:$n,minFilter:ps,samples:Math.max(4,Ut.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:we.workingColorSpace})}let Dt=A.state.transmissionRenderTarget[$.id],Ft=$.viewport||it;Dt.setSize(Ft.z*U.transmissionResolutionScale,Ft.w*U.transmissionResolutionScale);let Nt=U.getRenderTarget(),Bt=U.getActiveCubeFace(),Jt=U.getActiveMipmapLevel();U.setRenderTarget(Dt),U.getClearColor(tt),gt=U.getClearAlpha(),gt<1&&U.setClearColor(16777215,.5),U.clear(),_t&&F.render(nt);let ue=U.toneMapping;U.toneMapping=Xi;let _e=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),Ie===!0&&rt.setGlobalState(U.clippingPlanes,$),je(w,nt,$),Vt.updateMultisampleRenderTarget(Dt),Vt.updateRenderTargetMipmap(Dt),kt.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let xe=0,Ze=z.length;xe<Ze;xe++){let Ue=z[xe],{object:Fe,geometry:fn,material:Wt,group:on}=Ue;if(Wt.side===qn&&Fe.layers.test($.layers)){let Me=Wt.side;Wt.side=Xn,Wt.needsUpdate=!0,nn(Fe,nt,$,fn,Wt,on),Wt.side=Me,Wt.needsUpdate=!0,$t=!0}}$t===!0&&(Vt.updateMultisampleRenderTarget(Dt),Vt.updateRenderTargetMipmap(Dt))}U.setRenderTarget(Nt,Bt,Jt),U.setClearColor(tt,gt),_e!==void 0&&($.viewport=_e),U.toneMapping=ue}function je(w,z,nt){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Dt=w.length;Z<Dt;Z++){let Ft=w[Z],{object:Nt,geometry:Bt,group:Jt}=Ft,ue=Ft.material;ue.allowOverride===!0&&$!==null&&(ue=$),Nt.layers.test(nt.layers)&&nn(Nt,z,nt,Bt,ue,Jt)}}function nn(w,z,nt,$,Z,Dt){V!==null&&Z.isNodeMaterial&&V.setObject(w,Z),w.onBeforeRender(U,z,nt,$,Z,Dt),w.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(U,z,nt,$,w,Dt),Z.transparent===!0&&Z.side===qn&&Z.forceSinglePass===!1?(Z.side=Xn,Z.needsUpdate=!0,U.renderBufferDirect(nt,z,$,Z,w,Dt),Z.side=ks,Z.needsUpdate=!0,U.renderBufferDirect(nt,z,$,Z,w,Dt),Z.side=qn):U.renderBufferDirect(nt,z,$,Z,w,Dt),w.onAfterRender(U,z,nt,$,Z,Dt)}function sn(w){let z=0;for(let nt of w)nt.texture!==null&&z++;return z}function Li(w,z,nt){z.isScene!==!0&&(z=bt);let $=Et.get(w),Z=A.state.lights,Dt=A.state.shadowsArray,Ft=Z.state.version,Nt=Q.getParameters(w,Z.state,Dt,z,nt,A.state.lightProbeGridArray),Bt=Q.getProgramCacheKey(Nt),Jt=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let ue=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=E.get(w.envMap||$.environment,ue),$.envMapRotation=$.environment!==null&&w.envMap===null?z.environmentRotation:w.envMapRotation,Jt===void 0&&(w.addEventListener("dispose",ae),Jt=new Map,$.programs=Jt,$.programVariants=new Map);let _e=Jt.get(Bt);if(_e!==void 0){if($.currentProgram===_e&&$.lightsStateVersion===Ft)return wo(w,Nt),_e}else Nt.uniforms=Q.getUniforms(w),V!==null&&w.isNodeMaterial&&V.build(w,nt,Nt),w.onBeforeCompile(Nt,U),_e=Q.acquireProgram(Nt,Bt),Jt.set(Bt,_e),$.uniforms=Nt.uniforms;let $t=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&($t.clippingPlanes=rt.uniform),wo(w,Nt),$.needsLights=vs(w),$.lightsStateVersion=Ft,$.needsLights&&($t.ambientLightColor.value=Z.state.ambient,$t.lightProbe.value=Z.state.probe,$t.sunLights.value=Z.state.sun,$t.sunLightShadows.value=Z.state.sunShadow,$t.directionalLights.value=Z.state.directional,$t.directionalLightShadows.value=Z.state.directionalShadow,$t.spotLights.value=Z.state.spot,$t.spotLightShadows.value=Z.state.spotShadow,$t.rectAreaLights.value=Z.state.rectArea,$t.ltc_1.value=Z.state.rectAreaLTC1,$t.ltc_2.value=Z.state.rectAreaLTC2,$t.pointLights.value=Z.state.point,$t.pointLightShadows.value=Z.state.pointShadow,$t.hemisphereLights.value=Z.state.hemi,$t.sunShadowMatrix.value=Z.state.sunShadowMatrix,$t.sunShadowCascade.value=Z.state.sunShadowCascade,$t.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,$t.spotLightMatrix.value=Z.state.spotLightMatrix,$t.spotLightMap.value=Z.state.spotLightMap,$t.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=sn(A.state.lightProbeGridArray),$.currentProgram=_e,$.uniformsList=null,_e}function Jn(w,z,nt,$,Z){let Dt=Et.get(w),Ft=Dt.currentProgram.id+","+$+","+Z,Nt=Dt.programVariants.get(Ft);return Nt===void 0?(Nt=Li(w,z,nt),Dt.programVariants.set(Ft,Nt)):(Dt.currentProgram=Nt,Dt.uniformsList=null,Dt.outputColorSpace=$,Dt.toneMapping=Z),Nt}function ys(w){if(w.uniformsList===null){let z=w.currentProgram.getUniforms();w.uniformsList=yo.seqWithValue(z.seq,w.uniforms)}return w.uniformsList}function wo(w,z){let nt=Et.get(w);nt.outputColorSpace=z.outputColorSpace,nt.batching=z.batching,nt.batchingColor=z.batchingColor,nt.instancing=z.instancing,nt.instancingColor=z.instancingColor,nt.instancingMorph=z.instancingMorph,nt.skinning=z.skinning,nt.morphTargets=z.morphTargets,nt.morphNormals=z.morphNormals,nt.morphColors=z.morphColors,nt.morphTargetsCount=z.morphTargetsCount,nt.numClippingPlanes=z.numClippingPlanes,nt.numIntersection=z.numClipIntersection,nt.vertexAlphas=z.vertexAlphas,nt.vertexTangents=z.vertexTangents,nt.toneMapping=z.toneMapping}function Eo(w,z,nt,$,Z){z.isScene!==!0&&(z=bt),Vt.resetTextureUnits();let Dt=z.fog,Ft=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Nt=ct===null?U.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:we.workingColorSpace,Bt=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Jt=E.get($.envMap||Ft,Bt),ue=$.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,_e=!!nt.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),$t=!!nt.morphAttributes.position,xe=!!nt.morphAttributes.normal,Ze=!!nt.morphAttributes.color,Ue=Xi;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Ue=U.toneMapping);let Fe=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,fn=Fe!==void 0?Fe.length:0,Wt=Et.get($),on=A.state.lights;if(Ie===!0&&(Ge===!0||w!==j)){let Oe=w===j&&$.id===Y;rt.setState($,w,Oe)}let Me=!1,Ji=!1;$.version===Wt.__version?Wt.needsLights&&Wt.lightsStateVersion!==on.state.version||Z.isBatchedMesh&&Wt.batching===!1||!Z.isBatchedMesh&&Wt.batching===!0||Z.isBatchedMesh&&Wt.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Wt.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Wt.instancing===!1||!Z.isInstancedMesh&&Wt.instancing===!0||Z.isSkinnedMesh&&Wt.skinning===!1||!Z.isSkinnedMesh&&Wt.skinning===!0||Z.isInstancedMesh&&Wt.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Wt.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Wt.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Wt.instancingMorph===!1&&Z.morphTexture!==null||Wt.envMap!==Jt||$.fog===!0&&Wt.fog!==Dt||Wt.numClippingPlanes!==void 0&&(Wt.numClippingPlanes!==rt.numPlanes||Wt.numIntersection!==rt.numIntersection)||Wt.vertexAlphas!==ue||Wt.vertexTangents!==_e||Wt.morphTargets!==$t||Wt.morphNormals!==xe||Wt.morphColors!==Ze||Wt.morphTargetsCount!==fn||Wt.numLightProbeGrids!==sn(A.state.lightProbeGridArray)?Me=!0:(Wt.outputColorSpace!==Nt||Wt.toneMapping!==Ue)&&(Ji=!0):(Me=!0,Wt.__version=$.version);let an=Wt.currentProgram;(Me===!0||Ji===!0)&&(an=Ji===!0?Jn($,z,Z,Nt,Ue):Li($,z,Z),V&&$.isNodeMaterial&&V.onUpdateProgram($,an,Wt));let dr=!1,Di=!1,Ki=!1,me=an.getUniforms(),Qe=Wt.uniforms;if(yt.useProgram(an.program)&&(dr=!0,Di=!0,Ki=!0),$.id!==Y&&(Y=$.id,Di=!0),dr||j!==w){yt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),me.setValue(P,"projectionMatrix",w.projectionMatrix),me.setValue(P,"viewMatrix",w.matrixWorldInverse);let ln=me.map.cameraPosition;ln!==void 0&&ln.setValue(P,ft.setFromMatrixPosition(w.matrixWorld)),Ut.logarithmicDepthBuffer&&me.setValue(P,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&me.setValue(P,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,Di=!0,Ki=!0)}if(Wt.needsLights&&(on.state.sunShadowMap.length>0&&me.setValue(P,"sunShadowMap",on.state.sunShadowMap,Vt),on.state.directionalShadowMap.length>0&&me.setValue(P,"directionalShadowMap",on.state.directionalShadowMap,Vt),on.state.spotShadowMap.length>0&&me.setValue(P,"spotShadowMap",on.state.spotShadowMap,Vt),on.state.pointShadowMap.length>0&&me.setValue(P,"pointShadowMap",on.state.pointShadowMap,Vt)),Z.isSkinnedMesh){me.setOptional(P,Z,"bindMatrix"),me.setOptional(P,Z,"bindMatrixInverse");let Oe=Z.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),me.setValue(P,"boneTexture",Oe.boneTexture,Vt))}Z.isBatchedMesh&&(me.setOptional(P,Z,"batchingTexture"),me.setValue(P,"batchingTexture",Z._matricesTexture,Vt),me.setOptional(P,Z,"batchingIdTexture"),me.setValue(P,"batchingIdTexture",Z._indirectTexture,Vt),me.setOptional(P,Z,"batchingColorTexture"),Z._colorsTexture!==null&&me.setValue(P,"batchingColorTexture",Z._colorsTexture,Vt));let Un=nt.morphAttributes;if((Un.position!==void 0||Un.normal!==void 0||Un.color!==void 0)&&at.update(Z,nt,an),(Di||Wt.receiveShadow!==Z.receiveShadow)&&(Wt.receiveShadow=Z.receiveShadow,me.setValue(P,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(Qe.envMapIntensity.value=z.environmentIntensity),Qe.dfgLUT!==void 0&&(Qe.dfgLUT.value=Cw()),Di){if(me.setValue(P,"toneMappingExposure",U.toneMappingExposure),Wt.needsLights&&ur(Qe,Ki),Dt&&$.fog===!0&&mt.refreshFogUniforms(Qe,Dt),mt.refreshMaterialUniforms(Qe,$,At,Lt,A.state.transmissionRenderTarget[w.id]),Wt.needsLights&&Wt.numLightProbeGrids>0){let Oe=v,ln=0;for(let Pn of A.state.lightProbeGridArray)Pn.texture!==null&&(Oe.textures[ln]=Pn.texture,Oe.min[ln]=Pn.boundingBox.min,Oe.max[ln]=Pn.boundingBox.max,Oe.resolution[ln]=Pn.resolution,ln++);for(let Pn in Oe)Oe[Pn].length=ln;Qe.probesSH.value=Oe.textures,Qe.probesMin.value=Oe.min,Qe.probesMax.value=Oe.max,Qe.probesResolution.value=Oe.resolution}yo.upload(P,ys(Wt),Qe,Vt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(yo.upload(P,ys(Wt),Qe,Vt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&me.setValue(P,"center",Z.center),me.setValue(P,"modelViewMatrix",Z.modelViewMatrix),me.setValue(P,"normalMatrix",Z.normalMatrix),me.setValue(P,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Oe=$.uniformsGroups;for(let ln=0,Pn=Oe.length;ln<Pn;ln++){let ka=Oe[ln];Qt.update(ka,an),Qt.bind(ka,an)}}return an}function ur(w,z){w.ambientLightColor.needsUpdate=z,w.lightProbe.needsUpdate=z,w.sunLights.needsUpdate=z,w.sunLightShadows.needsUpdate=z,w.directionalLights.needsUpdate=z,w.directionalLightShadows.needsUpdate=z,w.pointLights.needsUpdate=z,w.pointLightShadows.needsUpdate=z,w.spotLights.needsUpdate=z,w.spotLightShadows.needsUpdate=z,w.rectAreaLights.needsUpdate=z,w.hemisphereLights.needsUpdate=z}function vs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,z,nt){let $=Et.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Et.get(w.texture).__webglTexture=z,Et.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:nt,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,z){let nt=Et.get(w);nt.__webglFramebuffer=z,nt.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(w,z=0,nt=0){ct=w,q=z,G=nt;let $=null,Z=!1,Dt=!1;if(w){let Nt=Et.get(w);if(Nt.__useDefaultFramebuffer!==void 0){yt.bindFramebuffer(P.FRAMEBUFFER,Nt.__webglFramebuffer),it.copy(w.viewport),pt.copy(w.scissor),ht=w.scissorTest,yt.viewport(it),yt.scissor(pt),yt.setScissorTest(ht),Y=-1;return}else if(Nt.__webglFramebuffer===void 0)Vt.setupRenderTarget(w);else if(Nt.__hasExternalTextures)Vt.rebindTextures(w,Et.get(w.texture).__webglTexture,Et.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let ue=w.depthTexture;if(Nt.__boundDepthTexture!==ue){if(ue!==null&&Et.has(ue)&&(w.width!==ue.image.width||w.height!==ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Vt.setupDepthRenderbuffer(w)}}let Bt=w.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(Dt=!0);let Jt=Et.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Jt[z])?$=Jt[z][nt]:$=Jt[z],Z=!0):w.samples>0&&Vt.useMultisampledRTT(w)===!1?$=Et.get(w).__webglMultisampledFramebuffer:Array.isArray(Jt)?$=Jt[nt]:$=Jt,it.copy(w.viewport),pt.copy(w.scissor),ht=w.scissorTest}else it.copy(Zt).multiplyScalar(At).floor(),pt.copy(fe).multiplyScalar(At).floor(),ht=de;if(nt!==0&&($=X),yt.bindFramebuffer(P.FRAMEBUFFER,$)&&yt.drawBuffers(w,$),yt.viewport(it),yt.scissor(pt),yt.setScissorTest(ht),Z){let Nt=Et.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_CUBE_MAP_POSITIVE_X+z,Nt.__webglTexture,nt)}else if(Dt){let Nt=z;for(let Bt=0;Bt<w.textures.length;Bt++){let Jt=Et.get(w.textures[Bt]);P.framebufferTextureLayer(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0+Bt,Jt.__webglTexture,nt,Nt)}}else if(w!==null&&nt!==0){let Nt=Et.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,Nt.__webglTexture,nt)}Y=-1};function fr(w){let z=Et.get(w);return(z.__readFormat!==w.format||z.__readType!==w.type)&&(z.__readFormat=w.format,z.__readType=w.type,z.__formatReadable=Ut.textureFormatReadable(w.format),z.__typeReadable=Ut.textureTypeReadable(w.type)),z}this.readRenderTargetPixels=function(w,z,nt,$,Z,Dt,Ft,Nt=0){if(!(w&&w.isWebGLRenderTarget)){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Et.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Ft!==void 0&&(Bt=Bt[Ft],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){yt.bindFramebuffer(P.FRAMEBUFFER,Bt);try{let Jt=w.textures[Nt],ue=Jt.format,_e=Jt.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Nt);let $t=fr(Jt);if($t.__formatReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($t.__typeReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=w.width-$&&nt>=0&&nt<=w.height-Z&&P.readPixels(z,nt,$,Z,Tt.convert(ue),Tt.convert(_e),Dt)}finally{let Jt=ct!==null?Et.get(ct).__webglFramebuffer:null;yt.bindFramebuffer(P.FRAMEBUFFER,Jt)}}},this.readRenderTargetPixelsAsync=async function(w,z,nt,$,Z,Dt,Ft,Nt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Et.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Ft!==void 0&&(Bt=Bt[Ft],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(z>=0&&z<=w.width-$&&nt>=0&&nt<=w.height-Z){yt.bindFramebuffer(P.FRAMEBUFFER,Bt);let Jt=w.textures[Nt],ue=Jt.format,_e=Jt.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Nt);let $t=fr(Jt);if($t.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($t.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=P.createBuffer();P.bindBuffer(P.PIXEL_PACK_BUFFER,xe),P.bufferData(P.PIXEL_PACK_BUFFER,Dt.byteLength,P.STREAM_READ),P.readPixels(z,nt,$,Z,Tt.convert(ue),Tt.convert(_e),0),P.bindBuffer(P.PIXEL_PACK_BUFFER,null);let Ze=ct!==null?Et.get(ct).__webglFramebuffer:null;yt.bindFramebuffer(P.FRAMEBUFFER,Ze);let Ue=P.fenceSync(P.SYNC_GPU_COMMANDS_COMPLETE,0);return P.flush(),await _g(P,Ue,4),P.bindBuffer(P.PIXEL_PACK_BUFFER,xe),P.getBufferSubData(P.PIXEL_PACK_BUFFER,0,Dt),P.bindBuffer(P.PIXEL_PACK_BUFFER,null),P.deleteBuffer(xe),P.deleteSync(Ue),Dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,z=null,nt=0){let $=Math.pow(2,-nt),Z=Math.floor(w.image.width*$),Dt=Math.floor(w.image.height*$),Ft=z!==null?z.x:0,Nt=z!==null?z.y:0;Vt.setTexture2D(w,0),P.copyTexSubImage2D(P.TEXTURE_2D,nt,0,0,Ft,Nt,Z,Dt),yt.unbindTexture()},this.copyTextureToTexture=function(w,z,nt=null,$=null,Z=0,Dt=0){let Ft,Nt,Bt,Jt,ue,_e,$t,xe,Ze,Ue=w.isCompressedTexture?w.mipmaps[Dt]:w.image;if(nt!==null)Ft=nt.max.x-nt.min.x,Nt=nt.max.y-nt.min.y,Bt=nt.isBox3?nt.max.z-nt.min.z:1,Jt=nt.min.x,ue=nt.min.y,_e=nt.isBox3?nt.min.z:0;else{let me=Math.pow(2,-Z);Ft=Math.floor(Ue.width*me),Nt=Math.floor(Ue.height*me),w.isDataArrayTexture?Bt=Ue.depth:w.isData3DTexture?Bt=Math.floor(Ue.depth*me):Bt=1,Jt=0,ue=0,_e=0}$!==null?($t=$.x,xe=$.y,Ze=$.z):($t=0,xe=0,Ze=0);let Fe=Tt.convert(z.format),fn=Tt.convert(z.type),Wt;z.isData3DTexture?(Vt.setTexture3D(z,0),Wt=P.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Vt.setTexture2DArray(z,0),Wt=P.TEXTURE_2D_ARRAY):(Vt.setTexture2D(z,0),Wt=P.TEXTURE_2D),yt.activeTexture(P.TEXTURE0),yt.pixelStorei(P.UNPACK_FLIP_Y_WEBGL,z.flipY),yt.pixelStorei(P.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),yt.pixelStorei(P.UNPACK_ALIGNMENT,z.unpackAlignment);let on=yt.getParameter(P.UNPACK_ROW_LENGTH),Me=yt.getParameter(P.UNPACK_IMAGE_HEIGHT),Ji=yt.getParameter(P.UNPACK_SKIP_PIXELS),an=yt.getParameter(P.UNPACK_SKIP_ROWS),dr=yt.getParameter(P.UNPACK_SKIP_IMAGES);yt.pixelStorei(P.UNPACK_ROW_LENGTH,Ue.width),yt.pixelStorei(P.UNPACK_IMAGE_HEIGHT,Ue.height),yt.pixelStorei(P.UNPACK_SKIP_PIXELS,Jt),yt.pixelStorei(P.UNPACK_SKIP_ROWS,ue),yt.pixelStorei(P.UNPACK_SKIP_IMAGES,_e);let Di=w.isDataArrayTexture||w.isData3DTexture,Ki=z.isDataArrayTexture||z.isData3DTexture;if(w.isDepthTexture){let me=Et.get(w),Qe=Et.get(z),Un=Et.get(me.__renderTarget),Oe=Et.get(Qe.__renderTarget);yt.bindFramebuffer(P.READ_FRAMEBUFFER,Un.__webglFramebuffer),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let ln=0;ln<Bt;ln++)Di&&(P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Et.get(w).__webglTexture,Z,_e+ln),P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Et.get(z).__webglTexture,Dt,Ze+ln)),P.blitFramebuffer(Jt,ue,Jt+Ft,ue+Nt,$t,xe,$t+Ft,xe+Nt,P.DEPTH_BUFFER_BIT,P.NEAREST);yt.bindFramebuffer(P.READ_FRAMEBUFFER,null),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Et.has(w)){let me=Et.get(w),Qe=Et.get(z);yt.bindFramebuffer(P.READ_FRAMEBUFFER,D),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,H);for(let Un=0;Un<Bt;Un++)Di?P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,me.__webglTexture,Z,_e+Un):P.framebufferTexture2D(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,me.__webglTexture,Z),Ki?P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Qe.__webglTexture,Dt,Ze+Un):P.framebufferTexture2D(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,Qe.__webglTexture,Dt),Z!==0?P.blitFramebuffer(Jt,ue,Jt+Ft,ue+Nt,$t,xe,$t+Ft,xe+Nt,P.COLOR_BUFFER_BIT,P.NEAREST):Ki?P.copyTexSubImage3D(Wt,Dt,$t,xe,Ze+Un,Jt,ue,Ft,Nt):P.copyTexSubImage2D(Wt,Dt,$t,xe,Jt,ue,Ft,Nt);yt.bindFramebuffer(P.READ_FRAMEBUFFER,null),yt.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else Ki?w.isDataTexture||w.isData3DTexture?P.texSubImage3D(Wt,Dt,$t,xe,Ze,Ft,Nt,Bt,Fe,fn,Ue.data):z.isCompressedArrayTexture?P.compressedTexSubImage3D(Wt,Dt,$t,xe,Ze,Ft,Nt,Bt,Fe,Ue.data):P.texSubImage3D(Wt,Dt,$t,xe,Ze,Ft,Nt,Bt,Fe,fn,Ue):w.isDataTexture?P.texSubImage2D(P.TEXTURE_2D,Dt,$t,xe,Ft,Nt,Fe,fn,Ue.data):w.isCompressedTexture?P.compressedTexSubImage2D(P.TEXTURE_2D,Dt,$t,xe,Ue.width,Ue.height,Fe,Ue.data):P.texSubImage2D(P.TEXTURE_2D,Dt,$t,xe,Ft,Nt,Fe,fn,Ue);yt.pixelStorei(P.UNPACK_ROW_LENGTH,on),yt.pixelStorei(P.UNPACK_IMAGE_HEIGHT,Me),yt.pixelStorei(P.UNPACK_SKIP_PIXELS,Ji),yt.pixelStorei(P.UNPACK_SKIP_ROWS,an),yt.pixelStorei(P.UNPACK_SKIP_IMAGES,dr),Dt===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&P.generateMipmap(Wt),yt.unbindTexture()},this.initRenderTarget=function(w){Et.get(w).__webglFramebuffer===void 0&&Vt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Vt.setTextureCube(w,0):w.isData3DTexture?Vt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Vt.setTexture2DArray(w,0):Vt.setTexture2D(w,0),yt.unbindTexture()},this.resetState=function(){q=0,G=0,ct=null,yt.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=we._getDrawingBufferColorSpace(t),e.unpackColorSpace=we._getUnpackColorSpace()}};function n0(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let v=0;v<s;v++)r[3*v+0]=n.getX(v),r[3*v+1]=n.getY(v),r[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let R=9*v,A=r[R+0],y=r[R+1],T=r[R+2],k=r[R+3],U=r[R+4],L=r[R+5],V=r[R+6],X=r[R+7],D=r[R+8],H=V-k,q=X-U,G=D-L,ct=A-k,Y=y-U,j=T-L,it=q*j-G*Y,pt=G*ct-H*j,ht=H*Y-q*ct,tt=1/(Math.sqrt(it*it+pt*pt+ht*ht)||1);c[3*v+0]=it*tt,c[3*v+1]=pt*tt,c[3*v+2]=ht*tt}let h=new Int32Array(s),u=new Float64Array(s*3),f=1;for(;f<s*2;)f<<=1;let d=f-1,g=new Int32Array(f),S=0;for(let v=0;v<s;v++){let R=3*v,A=Math.trunc(r[R+0]*a),y=Math.trunc(r[R+1]*a),T=Math.trunc(r[R+2]*a),k=(Math.imul(A,73856093)^Math.imul(y,19349663)^Math.imul(T,83492791))&d;for(;;){let U=g[k];if(U===0){let V=3*S;u[V+0]=A,u[V+1]=y,u[V+2]=T,g[k]=S+1,h[v]=S++;break}let L=3*(U-1);if(u[L+0]===A&&u[L+1]===y&&u[L+2]===T){h[v]=U-1;break}k=k+1&d}}let m=new Int32Array(S+1);for(let v=0;v<s;v++)m[h[v]+1]++;for(let v=0;v<S;v++)m[v+1]+=m[v];let p=new Int32Array(s),M=m.slice(0,S);for(let v=0;v<l;v++){let R=3*v;p[M[h[R+0]]++]=v,p[M[h[R+1]]++]=v,p[M[h[R+2]]++]=v}let C=new Float32Array(s*3);for(let v=0;v<l;v++){let R=3*v,A=c[R+0],y=c[R+1],T=c[R+2];for(let k=0;k<3;k++){let U=R+k,L=h[U],V=0,X=0,D=0;for(let q=m[L],G=m[L+1];q<G;q++){let ct=3*p[q],Y=c[ct+0],j=c[ct+1],it=c[ct+2];A*Y+y*j+T*it>o&&(V+=Y,X+=j,D+=it)}let H=1/(Math.sqrt(V*V+X*X+D*D)||1);C[3*U+0]=V*H,C[3*U+1]=X*H,C[3*U+2]=D*H}}return e.setAttribute("normal",new Tn(C,3,!1)),e}var Rw=Math.PI/6;async function kf(i){let t=new DataView((await _u(i.data)).buffer),e=new Float32Array(3*i.points);for(let r=0;r<e.length;++r)e[r]=i.low[r%3]+i.step[r%3]*t.getUint16(2*r,!0);let n=new Uint16Array(3*i.triangles);for(let r=0;r<n.length;++r)n[r]=t.getUint16(2*(e.length+r),!0);let s=new rn;return s.setAttribute("position",new Tn(e,3)),s.setIndex(new Tn(n,1)),n0(s,Rw)}var gi=6;function ch(i,t){let e=i.lengthSq()>0?i.clone().normalize():new O(0,0,1),n=()=>new O(0,0,1).setComponent(2,Math.abs(e.z)>.9?0:1).setComponent(1,Math.abs(e.z)>.9?1:0).cross(e),s=t===null?n():t.clone().addScaledVector(e,-t.dot(e));return s.length()<1e-6&&(s=n()),s.normalize(),[s,new O().crossVectors(e,s),e]}function Da([i,t,e],n,s){return new ve().makeBasis(i.clone().multiplyScalar(n[0]),t.clone().multiplyScalar(n[1]),e.clone().multiplyScalar(n[2])).setPosition(s)}function i0(i,t,e){let n=t.length,s=new Float32Array(3*gi*n),r=new Float32Array(3*gi*n),o=[],[a,l,c]=[new O,new O,new O];for(let h=0;h<n;++h){a.subVectors(t[Math.min(h+1,n-1)],t[Math.max(h-1,0)]).normalize(),l.addScaledVector(a,-l.dot(a)),l.length()<.001&&l.copy(ch(a,null)[0]),l.normalize(),c.crossVectors(a,l);for(let u=0;u<gi;++u){let[f,d]=[Math.cos(2*Math.PI*u/gi),Math.sin(2*Math.PI*u/gi)],g=3*(h*gi+u);for(let p=0;p<3;++p){let M=f*l.getComponent(p)+d*c.getComponent(p);r[g+p]=M,s[g+p]=t[h].getComponent(p)+e*M}if(h===0)continue;let[S,m]=[(h-1)*gi+u,(h-1)*gi+(u+1)%gi];o.push(S,m,S+gi,m,m+gi,S+gi)}}i.setIndex(o),i.setAttribute("position",new Je(s,3)),i.setAttribute("normal",new Je(r,3)),i.computeBoundingBox(),i.computeBoundingSphere()}var[Pw,s0,r0,Iw]=[.05,.006,.018,.2],o0="#64748b";function Vf(i){return new ee(CSS.supports("color",i.color)?i.color:o0).multiplyScalar(i.shade??1)}function Gf(i,t){let e=new ds({color:Vf(i)});i.opacity!==void 0&&Object.assign(e,{transparent:!0,opacity:i.opacity,depthWrite:!1});let n=new _n(t,e);return n.matrixAutoUpdate=!1,n}function ci(i,t,e){let n=e.first+i[t];return new O(e.numbers[n],e.numbers[n+1],e.numbers[n+2])}function a0(i,t,e,n){let[s,r,o]=i.sizes?.[t]??[1,-1,!0];return s*(r<0?1:n.numbers[n.first+r])*(o?e.length:1)}function l0(i,t,e){let{numbers:n}=i,s=ci(n,"at",e),r="to"in n?ci(n,"to",e).sub(s):null,o=r??("z"in n?ci(n,"z",e):new O(0,0,1)),a=[0,1,2].map(c=>a0(i,c,t,e));i.scale?a.fill(o.length()*t.scales[i.scale]):r!==null&&(a[2]=o.length());let l=ch(o,"x"in n?ci(n,"x",e):null);if(i.still){let c=t.center.clone().sub(s),[h,,u]=l;s.add("x"in n?h.clone().multiplyScalar(c.dot(h)):c.addScaledVector(u,-c.dot(u)))}return s.addScaledVector(l[2],(i.offset??0)*t.length),{axes:l,sizes:a,at:s}}function Lw(i,t,e){let n=i.form==="file",s=n?e.meshes[t.mesh??-1]:e.forms.get(i.form??""),r=Gf(i,s??new rn);return n&&(r.material.side=qn),{object:r,update(o){let{axes:a,sizes:l,at:c}=l0(i,e,o);r.matrix.copy(Da(a,l,c))}}}function Dw(i,t,e){let n=Gf(i,new rn);n.userData.bent=!0;let s="";return{object:n,update(r){let o=a0(i,2,e,r),a;if(i.form==="coil"){let{axes:l,sizes:c,at:h}=l0(i,e,r);if(n.matrix.copy(Da(l,[1,1,1],h)),s===`${c}`)return;s=`${c}`,a=e.coil.map(([u,f,d])=>new O(u*c[0],f*c[1],d*c[2]))}else{let l=i.numbers.points;a=Array.from({length:i.count??0},(c,h)=>ci({at:l+3*h},"at",r))}i0(n.geometry,a,o)}}}function Nw(i,t,e){let n=new Dn,[s,r]=["cylinder","cone"].map(o=>Gf(i,e.forms.get(o)??new rn));return n.add(s,r),{object:n,update(o){let a=ci(i.numbers,"at",o),l="to"in i.numbers?ci(i.numbers,"to",o).sub(a):ci(i.numbers,"vector",o);i.scale?l.multiplyScalar(e.scales[i.scale]):"to"in i.numbers||l.setLength(Iw*e.length);let c=l.length();if(n.visible=c>1e-6*e.length,!n.visible)return;let h=Math.min(Pw*e.length,.6*c),u=ch(l,null),f=a.clone().addScaledVector(u[2],c-h);s.matrix.copy(Da(u,[s0*e.length,s0*e.length,c-h],a)),r.matrix.copy(Da(u,[r0*e.length,r0*e.length,h],f))}}}function Uw(i,t,e){let n=new Dn,s=new us(new rn,new Ds({color:Vf(i)})),r=new us(s.geometry.clone(),new Ds({color:Vf(i),transparent:!0,opacity:.25}));s.frustumCulled=r.frustumCulled=!1,n.add(s,r);let o=null;return{object:n,update(){},follow(a,l){if(a!==o){o=a;let c=new Float32Array(3*a.count),h=e.first+i.numbers.at;for(let u=0;u<a.count;++u)for(let f=0;f<3;++f)c[3*u+f]=a.at(u,h+f);for(let u of[s,r])u.geometry.dispose(),u.geometry=new rn,u.geometry.setAttribute("position",new Tn(c,3))}s.geometry.setDrawRange(0,l+1)}}}function Hf(i,t,e){let n=document.createElement("canvas"),s=n.getContext("2d"),r="48px system-ui, sans-serif";if(s===null)return new hs;s.font=r,n.width=Math.ceil(s.measureText(i).width)+16,n.height=64,s.font=r,s.fillStyle=e,s.textBaseline="middle",s.fillText(i,8,34);let o=new hs(new lo({map:new la(n),depthTest:!1}));return o.userData.words=i,o.scale.set(t*n.width/64,t,1),o}function Fw(i,t,e){let n=Hf(t.texts.text??t.name,.06*e.length,o0);return{object:n,update:s=>{n.position.copy(ci(i.numbers,"at",s))}}}var Ow={surface:Lw,line:Dw,arrow:Nw,trace:Uw,label:Fw};function hh(i,t){let e=new Dn,[n,s]=[!0,!1].map(o=>i.parts.filter(a=>(a.still??!1)===o).map(a=>Ow[a.primitive](a,i,t)));for(let{object:o}of[...n,...s])e.add(o);let r=null;return{object:e,shape:i,update:o=>s.forEach(a=>a.update(o)),follow(o,a){for(let c of s)c.follow?.(o,a);if(o===r)return;r=o;let l=Float64Array.from({length:o.width},(c,h)=>o.at(0,h));for(let c of n)c.update({numbers:l,first:t.first})}}}var d0=[["velocity","v","Velocities of masses"],["acceleration","a","Accelerations of masses"],["admissible","\u2202r/\u2202q","Admissible motions of masses: each coordinate alone"],["reaction","reactions","Forces and torques of joints, rods and wires"],["constraint","constraints","Forces of constraints on masses"],["friction","friction","Dry friction: its forces, and whether it sticks or slides"]],Bw={velocity:"m/s",acceleration:"m/s\xB2",reaction:"N","reaction torque":"N\xB7m",constraint:"N",friction:"N",force:"N",torque:"N\xB7m"},c0=["#db2777","#7c3aed","#0891b2","#65a30d","#ca8a04","#dc2626","#2563eb","#0d9488"],h0=.3,zw=.4,Wf=8,u0=1e-10,kw=["open","slides","sticks"],uh=class{constructor(t,e,n){this.vectors=t;this.sizes=e;let s=t.shapes.flatMap(r=>r.texts.coordinate??[]);this.coordinates=[...new Set(s)];for(let r of t.shapes.filter(f0)){let o=this.coordinates.indexOf(r.texts.coordinate??"");if(o>=0)for(let c of r.parts)c.color=c0[o%c0.length];let a=this.scales.get(Na(r))??{...e,first:t.first,scales:{}};this.scales.set(Na(r),a);let l=hh(r,a);l.object.traverse(c=>c.userData.shape=r),l.object.visible=!1,this.drawn.push(l),n.add(l.object)}}vectors;sizes;drawn=[];shown=new Set;coordinates;coordinate="";scales=new Map;motion=null;row=0;largest=0;numbers=new Float64Array(0);has(t){return this.vectors.shapes.some(e=>Xf(e)===t)}take(t){this.motion=t,this.numbers=new Float64Array(t.width);let e=new Map;for(let n of this.vectors.shapes.filter(f0)){let s=this.vectors.first+n.numbers.vector;for(let r=0;r<t.count;++r){let o=Math.hypot(t.at(r,s),t.at(r,s+1),t.at(r,s+2));Number.isFinite(o)&&e.set(Na(n),Math.max(e.get(Na(n))??0,o))}}this.largest=0;for(let n of this.vectors.shapes.filter(({kind:s})=>s==="friction")){let s=this.vectors.first+n.numbers.value;this.largest=Math.max(this.largest,t.largest(s),n.texts.components==="2"?t.largest(s+1):0)}for(let[n,s]of this.scales){let r=e.get(n)??0,o=n.startsWith("reaction torque")?this.sizes.length*(e.get("reaction N")??0):0,a=r>u0*o?h0*this.sizes.length/r:0;s.scales={force:a,torque:zw*a}}}pose(t){if(this.motion!==null&&this.motion.count>0){let n=Math.min(t,this.motion.last);this.motion.state(n,this.numbers),this.row=this.motion.rowAt(n)}let e={numbers:this.numbers,first:this.vectors.first};for(let n of this.drawn){let s=this.coordinate===""||(n.shape.texts.coordinate??this.coordinate)===this.coordinate,r=this.shown.has(Xf(n.shape))&&s&&this.motion!==null;n.object.visible=r,r&&n.update(e),n.object.updateMatrixWorld(!0)}}value(t){if(t.kind==="friction")return this.rubs(t);let e=ci(t.numbers,"vector",{numbers:this.numbers,first:this.vectors.first});return`${Ua(e.length())} ${So(t)}`}legend(){let t=[];for(let[r,o]of this.scales){let a=this.vectors.shapes.find(l=>Na(l)===r);a===void 0||!this.shown.has(Xf(a))||o.scales.force===0||t.push(`${a.kind}: longest ${Ua(h0*this.sizes.length/o.scales.force)} ${So(a)}`)}if(!this.shown.has("friction")||this.motion===null)return t;let n=[...new Map(this.vectors.shapes.filter(({kind:r})=>r==="friction").map(r=>[r.name,r])).values()].map(r=>`${r.name}: ${this.rubs(r)}`),s=n.length>Wf?[`and ${n.length-Wf} more`]:[];return[...t,...n.slice(0,Wf),...s]}rubs(t){let{first:e}=this.vectors,n=kw[this.motion?.at(this.row,e+t.numbers.mode)??0]??"";if(n==="open")return n;let s=e+t.numbers.value,r=Math.hypot(...this.numbers.subarray(s,s+Number(t.texts.components)));return`${n}, ${Ua(r>u0*this.largest?r:0)} ${So(t)}`}};function f0(i){return"vector"in i.numbers}function So(i){return i.texts.unit??Bw[i.kind]??""}function Ua(i){return Number(i.toPrecision(3)).toString()}function Xf(i){return i.kind==="reaction torque"?"reaction":i.kind}function Na(i){return`${i.kind} ${So(i)}`}var Vw=[.1,.25,.5,1,2,4],Gw=[1,60],Hw=5;function Ww(i){let[t,e]=Gw;return i>=t&&i<=e?1:Number(Lr(i/Hw).toPrecision(1))}var fh=class{constructor(t,e,n){this.moved=n;this.time=t.start,this.span=[t.start,t.stop],this.again=t.modes!==void 0,this.speed=this.again?1:Ww(t.stop-t.start);let s=this.speed===1?Vw:[...[.1,.2,.5,1,2,5].map(o=>o*this.speed),1];this.choices=[...new Set(s.map(o=>Number(o.toPrecision(3))))].sort((o,a)=>o-a),this.button=document.createElement("button"),this.button.className="play",this.button.onclick=()=>this.toggle(),this.bar=document.createElement("input"),Object.assign(this.bar,{type:"range",min:`${t.start}`,max:`${t.stop}`,step:"any",value:`${t.start}`}),this.bar.setAttribute("aria-label","Time"),this.bar.oninput=()=>this.go(Number(this.bar.value)),this.clock=document.createElement("output"),this.clock.className="clock",this.ticks=document.createElement("div"),this.ticks.className="ticks",this.ticks.setAttribute("aria-hidden","true");let r=document.createElement("div");r.className="track",r.append(this.ticks,this.bar),this.chooser=this.speeds(),e.append(this.button,r,this.clock,this.chooser),this.mark(t.events),this.show()}moved;time;speed;choices;pace=1;span;again;running=!1;before=0;bar;button;clock;ticks;chooser;over(t,e,n){let[s,r]=this.span,o=(this.time-s)/(r-s||1),a=s===t&&r===e;this.span=[t,e],this.pace=n,Object.assign(this.bar,{min:`${t}`,max:`${e}`}),a||(this.time=t+o*(e-t)),this.show()}faster(t){let e=Math.min(Math.max(this.choices.indexOf(this.speed)+t,0),this.choices.length-1);this.speed=this.choices[e],this.chooser.value=`${this.speed}`}speeds(){let t=document.createElement("select");t.setAttribute("aria-label","Speed");for(let e of this.choices)t.append(new Option(`${e}\xD7`,`${e}`,e===this.speed,e===this.speed));return t.onchange=()=>this.speed=Number(t.value),t}mark(t){let[e,n]=this.span;this.ticks.replaceChildren(...sl(t,e,n).map(({time:s,name:r,kind:o})=>{let a=document.createElement("i");return a.style.left=`${100*(s-e)/(n-e)}%`,a.title=`${r} ${o}`,a.className=o,a}))}toggle(){this.running?this.pause():this.play()}play(){this.time>=this.span[1]&&([this.time]=this.span),this.running=!0,this.before=performance.now(),requestAnimationFrame(t=>this.tick(t)),this.show()}pause(){this.running=!1,this.show()}go(t){this.time=Math.min(Math.max(t,this.span[0]),this.span[1]),this.show(),this.moved(this.time)}step(t){this.pause(),this.go(this.time+t*(this.span[1]-this.span[0]))}get digits(){return Math.min(Math.max(2-Math.floor(Math.log10((this.span[1]-this.span[0])/2)),2),9)}tick(t){if(!this.running)return;let e=this.time+(t-this.before)/1e3*this.speed*this.pace;if(this.before=t,e>=this.span[1]&&!this.again){this.go(this.span[1]),this.pause();return}this.go(e>=this.span[1]?this.span[0]:e),requestAnimationFrame(n=>this.tick(n))}show(){this.button.textContent=this.running?"\u275A\u275A":"\u25B6",this.button.setAttribute("aria-label",this.running?"Pause":"Play"),this.bar.value=`${this.time}`,this.clock.value=`${this.time.toFixed(this.digits)} s`}};var _s={left:62,right:10,top:8,bottom:34},Xw="http://www.w3.org/2000/svg";function m0(i){let t=document.createElement("div");t.className="locus";let e=i.unit&&i.unit!=="1"?` [${i.unit}]`:"",[n,s]=[Math.min(...i.values),Math.max(...i.values)],r=(l,c)=>i.values.flatMap((h,u)=>i.eigenvalues[u].flatMap(f=>f===null?[]:[{x:l(h,f),y:c(f),part:(h-n)/(s-n||1),words:`${i.name} = ${h.toPrecision(4)}`}])),o=i.thresholds.map(l=>l.value);t.append(qf(r((l,c)=>c[0],l=>l[1]),"real part [1/s]","imaginary part [1/s]",[],!0),qf(r(l=>l,l=>l[0]),`${i.name}${e}`,"real part [1/s]",o,!1),qf(r(l=>l,l=>Math.abs(l[1])/(2*Math.PI)),`${i.name}${e}`,"frequency [Hz]",o,!1));let a=document.createElement("ul");for(let{value:l,kind:c,frequency:h,unstable_above:u}of i.thresholds){let f=document.createElement("li"),d=h>0?` at ${h.toPrecision(4)} Hz`:"";f.textContent=`${c}${d} ${u?"above":"below"} ${i.name} = ${l.toPrecision(6)} ${i.unit}`,a.append(f)}return i.thresholds.length>0&&t.append(a),t}function cr(i,t,e=""){let n=document.createElementNS(Xw,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,`${r}`);return e!==""&&(n.textContent=e),n}function p0(i){let[t,e]=[Math.min(...i),Math.max(...i)],n=e>t?.06*(e-t):1;return[t-n,e+n]}function qf(i,t,e,n,s){let r=cr("svg",{viewBox:"0 0 420 200",role:"img","aria-label":`${e} over ${t}`}),[o,a]=p0([...i.map(g=>g.x),...s?[0]:[]]),[l,c]=p0([...i.map(g=>g.y),0]),h=g=>_s.left+(g-o)/(a-o)*(420-_s.left-_s.right),u=g=>200-_s.bottom-(g-l)/(c-l)*(200-_s.top-_s.bottom),f=(g,S,m)=>{r.append(cr("line",{x1:g[0],y1:g[1],x2:S[0],y2:S[1],class:m}))};f([h(o),u(0)],[h(a),u(0)],"axis"),s&&f([h(0),u(l)],[h(0),u(c)],"axis");for(let g of n)f([h(g),u(l)],[h(g),u(c)],"threshold");for(let g of i){let S=cr("circle",{cx:h(g.x).toFixed(2),cy:u(g.y).toFixed(2),r:2,fill:`hsl(${(230-190*g.part).toFixed(0)} 70% 50%)`});S.append(cr("title",{},g.words)),r.append(S)}let d=[[h(o),180,"start",o.toPrecision(3)],[h(a),180,"end",a.toPrecision(3)],[_s.left-4,u(l),"end",l.toPrecision(3)],[_s.left-4,u(c)+9,"end",c.toPrecision(3)]];for(let[g,S,m,p]of d)r.append(cr("text",{x:g,y:S,"text-anchor":m},p));return r.append(cr("text",{x:(_s.left+420)/2,y:194,"text-anchor":"middle"},t)),r.append(cr("text",{x:-200/2+10,y:12,"text-anchor":"middle",transform:"rotate(-90)"},e)),r}var dh=class{constructor(t,e,n){this.head=t;this.chosen=n;let s=document.createElement("section");s.id="runs",t.modes!==void 0?this.modes(s,t.modes):t.runs!==void 0&&t.runs.length>1&&this.sweep(s,t.runs.map(r=>r.label)),e.prepend(s)}head;chosen;level=0;mode=0;buttons=[];sweep(t,e){let n=document.createElement("label"),s=document.createElement("input");Object.assign(s,{type:"range",min:"0",max:`${e.length-1}`,step:"1",value:"0"}),s.setAttribute("aria-label","Run");let r=document.createElement("output"),o=()=>{let a=Number(s.value);r.textContent=`Run ${a+1} of ${e.length}: ${e[a]}`,s.setAttribute("aria-valuetext",r.textContent)};s.oninput=()=>{o(),this.chosen(Number(s.value))},o(),n.append(r,s),t.append(n)}modes(t,e){let n=this.head.levels??[""];this.level=Math.min(1,n.length-1);let s=document.createElement("p");s.textContent=this.head.stability??"";let r=document.createElement("div");r.className="modes",e.forEach((l,c)=>{let h=document.createElement("button");h.textContent=`${c+1}: ${qw(l)}`,h.onclick=()=>{this.mode=c,this.show(e,a)},this.buttons.push(h),r.append(h)});let o=document.createElement("select");o.setAttribute("aria-label","Amplitude"),n.forEach((l,c)=>o.append(new Option(`amplitude: ${l}`,`${c}`,c===this.level,c===this.level))),o.onchange=()=>{this.level=Number(o.value),this.show(e,a)};let a=document.createElement("table");a.className="shape",t.append(s,r,o,a),this.head.locus!=null&&t.append(m0(this.head.locus)),this.show(e,a)}get run(){return this.mode*(this.head.levels?.length??1)+this.level}show(t,e){this.buttons.forEach((r,o)=>r.ariaPressed=`${o===this.mode}`);let n=document.createElement("tr");n.innerHTML='<th scope="col">shape</th><th scope="col">size</th><th scope="col">phase</th>';let s=t[this.mode].shape.map(({name:r,size:o,phase:a})=>{let l=document.createElement("tr");for(let c of[r,o.toPrecision(3),o>1e-9?`${a.toFixed(0)}\xB0`:""]){let h=document.createElement("td");h.textContent=c,l.append(h)}return l});e.replaceChildren(n,...s),this.chosen(this.run)}};function qw(i){let[t]=i.eigenvalue,e=i.frequency>0?[`${i.frequency.toPrecision(4)} Hz`]:[`${t.toPrecision(4)} 1/s`];return i.frequency>0&&i.damping!==null&&Math.abs(i.damping)>1e-7&&e.push(`damping ${i.damping.toPrecision(3)}`),i.constant!==null&&e.push(`${i.constant>0?"falls":"grows"} in ${Math.abs(i.constant).toPrecision(3)} s`),e.join(", ")}var Yw=1e-12,$w=12;function Zw(i){return i.group==="parameter"||i.kind!=="Real"}function g0({minimum:i,maximum:t,display:e},n){let s=r=>Math.abs(n-r)<=Yw*(Math.abs(r)+Math.abs(e.shift/e.scale));return[i,t].find(r=>r!==null&&s(r))??n}function Jw(i,t){let{minimum:e,maximum:n}=i;if(Number.isNaN(t))return"this is no number";let s=ph(i,t);return Number.isFinite(t)?i.kind!=="Real"&&!Number.isSafeInteger(t)?`${s} is no whole number below 2^53`:e!==null&&t<e?`${s} is below min = ${ph(i,e)}`:n!==null&&t>n?`${s} is above max = ${ph(i,n)}`:"":`${s} is not finite`}function Yf(i,t,e){let n=Jw(i,t),s=Number.isFinite(t)&&(n===""||!Zw(i));return n===""?{taken:s,words:n}:{taken:s,words:s?`${n}; the run takes it`:`${n}; the value stays ${ph(i,e)}`}}function ph({display:i},t){return`${Ir(t*i.scale+i.shift,$w)} ${i.unit}`.trim()}var Kw=[["start","Start values"],["parameter","Parameters"],["input","Inputs"]],$f=1e3;function jw(i,t){let{minimum:e,maximum:n,display:s}=i,r=Math.min(Math.max(i.value,e??-1/0),n??1/0),[o,a]=r===0?[-1,1]:[r/Math.sqrt(10),r*Math.sqrt(10)];if(i.angle)[o,a]=[Math.min(-Math.PI,r),Math.max(Math.PI,r)];else if(i.group!=="parameter"){let l=Lr((Math.max(2*Math.abs(r),t)||1)*s.scale)/s.scale;[o,a]=[-l,l]}return o>a&&([o,a]=[a,o]),[e??o,n??a]}function Zf(i,t){return Ir(t*i.display.scale+i.display.shift,4)}function Qw(i){return i.split(/(?<=[._])|(?=\[)/).flatMap(t=>[t,document.createElement("wbr")])}var mh=class{constructor(t,e,n,s){this.head=t;this.motion=e;this.place=n;this.changed=s;this.values=new Map([...t.parameters,...t.inputs].map(o=>[o,o.value]));for(let[o,a]of Kw){let l=[...this.values.keys()].filter(u=>u.group===o);if(l.length===0)continue;let c=document.createElement("details");c.open=l.length<=24;let h=document.createElement("summary");h.textContent=a,c.append(h,...l.map(u=>this.row(u))),n.append(c)}let r=document.createElement("button");r.textContent="Reset all",r.onclick=()=>{for(let o of this.values.keys())this.values.set(o,o.value);n.querySelectorAll("input").forEach(o=>o.dispatchEvent(new Event("reread"))),s()},n.append(r)}head;motion;place;changed;values;get parameters(){return Float64Array.from(this.head.parameters,t=>this.values.get(t)??t.value)}get inputs(){return Float64Array.from(this.head.inputs,t=>this.values.get(t)??t.value)}take(t){this.head.parameters.forEach((e,n)=>this.values.set(e,t[n])),this.place.querySelectorAll("input").forEach(e=>e.dispatchEvent(new Event("reread")))}largest(t){let e=this.head.columns.find(o=>o.name===t),n=this.head.columns.map((o,a)=>e!==void 0&&o.kind===e.kind&&o.unit===e.unit?this.motion.largest(a):0),[s,r]=[e===void 0?0:n[this.head.columns.indexOf(e)],Math.max(...n)];return s>1e-9*r?s:r}row(t){let e=t.group==="start"?t.name.replace(/\.start$/,""):t.name,[n,s]=jw(t,t.group==="start"?this.largest(e):0),r=document.createElement("label");r.title=t.doc??"";let o=document.createElement("span");o.append(...Qw(e));let a=document.createElement("input"),l=t.kind!=="Real";Object.assign(a,{type:"range",min:"0",max:`${$f}`,step:l?"any":"1"}),a.setAttribute("aria-label",t.name);let c=document.createElement("input");Object.assign(c,{type:"number",step:"any"}),c.setAttribute("aria-label",`${t.name} in ${t.display.unit||"SI units"}`);let h=document.createElement("span");h.className="unit",h.textContent=t.display.unit;let u=document.createElement("span");u.className="fault",u.setAttribute("aria-live","polite");let f=m=>{u.textContent=m,u.hidden=m==="",c.setAttribute("aria-invalid",`${m!==""}`)},d=()=>this.values.get(t)??t.value,g=()=>{let m=d();a.value=`${$f*(m-n)/(s-n||1)}`,c.value=Zf(t,m),f(Yf(t,m,m).words)},S=m=>{let p=g0(t,m),{taken:M,words:C}=Yf(t,p,d());M&&(this.values.set(t,p),this.changed()),g(),f(C)};return a.oninput=()=>{let m=n+(s-n)*Number(a.value)/$f;S(l?Math.round(m):m)},c.onchange=()=>S((c.valueAsNumber-t.display.shift)/t.display.scale),a.addEventListener("reread",g),r.ondblclick=()=>S(t.value),g(),r.append(o,a,c,h,u),r}};var gh=class{lines;pinned=[];constructor(t,e,n,s){this.lines=t.source.split(`
`).map((r,o)=>{let a=document.createElement("div");a.className="line",a.dataset.number=`${o+1}`,a.textContent=r===""?"\u200B":r;let l={first:[o+1,1],last:[o+2,1]};return a.onpointerenter=()=>n(l),a.onpointerleave=()=>n(null),a.onclick=()=>s(l),a}),e.append(...this.lines)}pin(t){this.pinned=t,this.mark(t)}mark(t){this.lines.forEach((e,n)=>{e.classList.toggle("marked",[...t,...this.pinned].some(s=>n+1>=s.first[0]&&n+1<=s.last[0]))}),t.length>0&&this.lines[t[0].first[0]-1]?.scrollIntoView({block:"nearest"})}};var _0={type:"change"},Kf={type:"start"},y0={type:"end"},_h=new Ls,x0=new ri,tE=Math.cos(70*ih.DEG2RAD),vn=new O,Zn=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Jf=1e-6,xh=class extends ya{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Bs.ROTATE,MIDDLE:Bs.DOLLY,RIGHT:Bs.PAN},this.touches={ONE:zs.ROTATE,TWO:zs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new oi,this._lastTargetPosition=new O,this._quat=new oi().setFromUnitVectors(t.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new fo,this._sphericalDelta=new fo,this._scale=1,this._panOffset=new O,this._rotateStart=new Kt,this._rotateEnd=new Kt,this._rotateDelta=new Kt,this._panStart=new Kt,this._panEnd=new Kt,this._panDelta=new Kt,this._dollyStart=new Kt,this._dollyEnd=new Kt,this._dollyDelta=new Kt,this._dollyDirection=new O,this._mouse=new Kt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=nE.bind(this),this._onPointerDown=eE.bind(this),this._onPointerUp=iE.bind(this),this._onContextMenu=hE.bind(this),this._onMouseWheel=oE.bind(this),this._onKeyDown=aE.bind(this),this._onTouchStart=lE.bind(this),this._onTouchMove=cE.bind(this),this._onMouseDown=sE.bind(this),this._onMouseMove=rE.bind(this),this._interceptControlDown=uE.bind(this),this._interceptControlUp=fE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(_0),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;vn.copy(e).sub(this.target),vn.applyQuaternion(this._quat),this._spherical.setFromVector3(vn),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Zn:n>Math.PI&&(n-=Zn),s<-Math.PI?s+=Zn:s>Math.PI&&(s-=Zn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(vn.setFromSpherical(this._spherical),vn.applyQuaternion(this._quatInverse),e.copy(this.target).add(vn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=vn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new O(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=vn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(_h.origin.copy(this.object.position),_h.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(_h.direction))<tE?this.object.lookAt(this.target):(x0.setFromNormalAndCoplanarPoint(this.object.up,this.target),_h.intersectPlane(x0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Jf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Jf||this._lastTargetPosition.distanceToSquared(this.target)>Jf?(this.dispatchEvent(_0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Zn/60*this.autoRotateSpeed*t:Zn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){vn.setFromMatrixColumn(e,0),vn.multiplyScalar(-t),this._panOffset.add(vn)}_panUp(t,e){this.screenSpacePanning===!0?vn.setFromMatrixColumn(e,1):(vn.setFromMatrixColumn(e,0),vn.crossVectors(this.object.up,vn)),vn.multiplyScalar(t),this._panOffset.add(vn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;vn.copy(s).sub(this.target);let r=vn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Kt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function eE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function nE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function iE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(y0),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function sE(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Bs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pe.DOLLY;break;case Bs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}break;case Bs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Kf)}function rE(i){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function oE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(i.preventDefault(),this.dispatchEvent(Kf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(y0))}function aE(i){this.enabled!==!1&&this._handleKeyDown(i)}function lE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case zs.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(i),this.state=Pe.TOUCH_ROTATE;break;case zs.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(i),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case zs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pe.TOUCH_DOLLY_PAN;break;case zs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Kf)}function cE(i){switch(this._trackPointer(i),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pe.NONE}}function hE(i){this.enabled!==!1&&i.preventDefault()}function uE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function fE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function yh(i,t){return new _n(t,new ds({color:i}))}function v0(i,t,e,n,s,r){let o=.16*t.length,a=new O().setFromMatrixColumn(n,0),l=new O().setFromMatrixColumn(n,1),c=new Dn;c.quaternion.setFromRotationMatrix(n);let h=e.getCenter(new O),u=Math.min(l.dot(e.min),l.dot(e.max))-l.dot(h);c.position.copy(h).addScaledVector(l,u-1.7*o),c.position.addScaledVector(a,(s-(r-1)/2)*2.6*o);let f=Hf(i.name,.4*o,"#64748b");f.position.set(0,-1.3*o,0),c.add(f);let d=p=>p.numbers[p.first+i.numbers.value];if(i.kind==="dial"){let p=yh(2450411,new Hi(.12*o,o,.12*o));return p.geometry.translate(0,.5*o,0),c.add(yh(9741240,new fa(o,.05*o,12,64)),p),{object:c,shape:i,update:M=>{p.rotation.set(0,0,d(M))}}}let g=yh(2450411,new Hi(.5*o,.5*o,.5*o));c.add(yh(9741240,new Hi(2.2*o,.06*o,.06*o)),g);let S=null,m=1;return{object:c,shape:i,update:p=>{g.position.x=.85*o*d(p)/m},follow(p){p!==S&&(S=p,m=Math.max(p.largest(t.first+i.numbers.value),1e-12))}}}var jf=class{constructor(){this.id=0,this.object=null,this.z=0,this.renderOrder=0}},Fa=class{constructor(){this.id=0,this.v1=new xs,this.v2=new xs,this.v3=new xs,this.normalModel=new O,this.vertexNormalsModel=[new O,new O,new O],this.vertexNormalsLength=0,this.color=new ee,this.material=null,this.uvs=[new Kt,new Kt,new Kt],this.z=0,this.renderOrder=0}},xs=class{constructor(){this.position=new O,this.positionWorld=new O,this.positionScreen=new Ae,this.visible=!0}copy(t){this.positionWorld.copy(t.positionWorld),this.positionScreen.copy(t.positionScreen)}},Oa=class{constructor(){this.id=0,this.v1=new xs,this.v2=new xs,this.vertexColors=[new ee,new ee],this.material=null,this.z=0,this.renderOrder=0}},Ba=class{constructor(){this.id=0,this.object=null,this.x=0,this.y=0,this.z=0,this.rotation=0,this.scale=new Kt,this.material=null,this.renderOrder=0}},vh=class{constructor(){let t,e,n=0,s,r,o=0,a,l,c=0,h,u,f=0,d,g,S=0,m,p=[],M=[],C={objects:[],lights:[],elements:[]},v=new O,R=new Ae,A=new Yn(new O(-1,-1,-1),new O(1,1,1)),y=new Yn,T=new Array(3),k=new ve,U=new ve,L=new ve,V=new Gi,X=[],D=[],H=[],q=[],G=[],ct=[],Y=new Ae,j=new Ae,it=new Ae,pt=[],ht=[null,null,null],tt=[{sign:1},{sign:-1}];function gt(){let K=[],ft=[],xt=[],bt=null,_t=new oe;function Yt(x){bt=x,_t.getNormalMatrix(bt.matrixWorld),K.length=0,ft.length=0,xt.length=0}function P(x){let B=x.position,st=x.positionWorld,Q=x.positionScreen;st.copy(B).applyMatrix4(m),Q.copy(st).applyMatrix4(U);let mt=1/Q.w;Q.x*=mt,Q.y*=mt,Q.z*=mt,x.visible=Q.x>=-1&&Q.x<=1&&Q.y>=-1&&Q.y<=1&&Q.z>=-1&&Q.z<=1}function ut(x,B,st){s=Zt(),s.position.set(x,B,st),P(s)}function kt(x,B,st){K.push(x,B,st)}function Ut(x,B,st){ft.push(x,B,st)}function yt(x,B){xt.push(x,B)}function Xt(x,B,st){return x.visible===!0||B.visible===!0||st.visible===!0?!0:(T[0]=x.positionScreen,T[1]=B.positionScreen,T[2]=st.positionScreen,A.intersectsBox(y.setFromPoints(T)))}function Et(x,B,st){return(st.positionScreen.x-x.positionScreen.x)*(B.positionScreen.y-x.positionScreen.y)-(st.positionScreen.y-x.positionScreen.y)*(B.positionScreen.x-x.positionScreen.x)<0}function Vt(x,B){let st=D[x],Q=D[B];st.positionScreen.copy(st.position).applyMatrix4(L),Q.positionScreen.copy(Q.position).applyMatrix4(L),Ge(st.positionScreen,Q.positionScreen)===!0&&(st.positionScreen.multiplyScalar(1/st.positionScreen.w),Q.positionScreen.multiplyScalar(1/Q.positionScreen.w),h=de(),h.id=bt.id,h.v1.copy(st),h.v2.copy(Q),h.z=Math.max(st.positionScreen.z,Q.positionScreen.z),h.renderOrder=bt.renderOrder,h.material=bt.material,bt.material.vertexColors&&(h.vertexColors[0].fromArray(ft,x*3),h.vertexColors[1].fromArray(ft,B*3)),C.elements.push(h))}function E(x,B,st,Q){let mt=D[x],vt=D[B],et=D[st],rt=mt.positionScreen.w,St=vt.positionScreen.w,F=et.positionScreen.w,at=rt*(mt.positionScreen.z+1),ot=St*(vt.positionScreen.z+1),Pt=F*(et.positionScreen.z+1),Tt=rt*(1-mt.positionScreen.z),Rt=St*(1-vt.positionScreen.z),Qt=F*(1-et.positionScreen.z);if(at<0&&ot<0&&Pt<0||Tt<0&&Rt<0&&Qt<0)return;if(at>=0&&ot>=0&&Pt>=0&&Tt>=0&&Rt>=0&&Qt>=0){if(Xt(mt,vt,et)===!1)return;if(Q.side===qn||Et(mt,vt,et)===!0){a=fe(),a.id=bt.id,a.v1.copy(mt),a.v2.copy(vt),a.v3.copy(et),a.z=(mt.positionScreen.z+vt.positionScreen.z+et.positionScreen.z)/3,a.renderOrder=bt.renderOrder,v.subVectors(et.position,vt.position),R.subVectors(mt.position,vt.position),v.cross(R),a.normalModel.copy(v),a.normalModel.applyMatrix3(_t).normalize();for(let lt=0;lt<3;lt++){let Ot=a.vertexNormalsModel[lt];Ot.fromArray(K,arguments[lt]*3),Ot.applyMatrix3(_t).normalize(),a.uvs[lt].fromArray(xt,arguments[lt]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(ft,x*3),C.elements.push(a)}return}Y.set(mt.positionScreen.x*rt,mt.positionScreen.y*rt,mt.positionScreen.z*rt,rt),j.set(vt.positionScreen.x*St,vt.positionScreen.y*St,vt.positionScreen.z*St,St),it.set(et.positionScreen.x*F,et.positionScreen.y*F,et.positionScreen.z*F,F),ht[0]=Y,ht[1]=j,ht[2]=it;let ie=Ie(ht);if(!(ie<3)){for(let lt=0;lt<ie;lt++){let Ot=p[lt],te=pt[lt];te||(te=new xs,pt[lt]=te);let Ct=1/Ot.w;te.positionScreen.set(Ot.x*Ct,Ot.y*Ct,Ot.z*Ct,1),te.positionWorld.copy(mt.positionWorld),te.visible=!0}for(let lt=1;lt<ie-1;lt++){let Ot=pt[0],te=pt[lt],Ct=pt[lt+1];if(Q.side===qn||Et(Ot,te,Ct)===!0){a=fe(),a.id=bt.id,a.v1.copy(Ot),a.v2.copy(te),a.v3.copy(Ct),a.z=(Ot.positionScreen.z+te.positionScreen.z+Ct.positionScreen.z)/3,a.renderOrder=bt.renderOrder,v.subVectors(et.position,vt.position),R.subVectors(mt.position,vt.position),v.cross(R),a.normalModel.copy(v),a.normalModel.applyMatrix3(_t).normalize();for(let ae=0;ae<3;ae++){let Be=a.vertexNormalsModel[ae];Be.fromArray(K,arguments[ae]*3),Be.applyMatrix3(_t).normalize(),a.uvs[ae].fromArray(xt,arguments[ae]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(ft,x*3),C.elements.push(a)}}}}return{setObject:Yt,projectVertex:P,checkTriangleVisibility:Xt,checkBackfaceCulling:Et,pushVertex:ut,pushNormal:kt,pushColor:Ut,pushUv:yt,pushLine:Vt,pushTriangle:E}}let Mt=new gt;function Lt(K){if(K.visible===!1)return;if(K.isLight)C.lights.push(K);else if(K.isMesh||K.isLine||K.isPoints){if(K.material.visible===!1||K.frustumCulled===!0&&V.intersectsObject(K)===!1)return;At(K)}else if(K.isSprite){if(K.material.visible===!1||K.frustumCulled===!0&&V.intersectsSprite(K)===!1)return;At(K)}let ft=K.children;for(let xt=0,bt=ft.length;xt<bt;xt++)Lt(ft[xt])}function At(K){t=he(),t.id=K.id,t.object=K,v.setFromMatrixPosition(K.matrixWorld),v.applyMatrix4(U),t.z=v.z,t.renderOrder=K.renderOrder,C.objects.push(t)}this.projectScene=function(K,ft,xt,bt){l=0,u=0,g=0,C.elements.length=0,K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),ft.parent===null&&ft.matrixWorldAutoUpdate===!0&&ft.updateMatrixWorld(),k.copy(ft.matrixWorldInverse),U.multiplyMatrices(ft.projectionMatrix,k),V.setFromProjectionMatrix(U),e=0,C.objects.length=0,C.lights.length=0,Lt(K),xt===!0&&C.objects.sort(Ne);let _t=C.objects;for(let Yt=0,P=_t.length;Yt<P;Yt++){let ut=_t[Yt].object,kt=ut.geometry;if(Mt.setObject(ut),m=ut.matrixWorld,r=0,ut.isMesh){let Ut=ut.material,yt=Array.isArray(Ut),Xt=kt.attributes,Et=kt.groups;if(Xt.position===void 0)continue;let Vt=Xt.position.array;for(let E=0,x=Vt.length;E<x;E+=3){let B=Vt[E],st=Vt[E+1],Q=Vt[E+2],mt=kt.morphAttributes.position;if(mt!==void 0){let vt=kt.morphTargetsRelative,et=ut.morphTargetInfluences;for(let rt=0,St=mt.length;rt<St;rt++){let F=et[rt];if(F===0)continue;let at=mt[rt];vt?(B+=at.getX(E/3)*F,st+=at.getY(E/3)*F,Q+=at.getZ(E/3)*F):(B+=(at.getX(E/3)-Vt[E])*F,st+=(at.getY(E/3)-Vt[E+1])*F,Q+=(at.getZ(E/3)-Vt[E+2])*F)}}Mt.pushVertex(B,st,Q)}if(Xt.normal!==void 0){let E=Xt.normal.array;for(let x=0,B=E.length;x<B;x+=3)Mt.pushNormal(E[x],E[x+1],E[x+2])}if(Xt.color!==void 0){let E=Xt.color.array;for(let x=0,B=E.length;x<B;x+=3)Mt.pushColor(E[x],E[x+1],E[x+2])}if(Xt.uv!==void 0){let E=Xt.uv.array;for(let x=0,B=E.length;x<B;x+=2)Mt.pushUv(E[x],E[x+1])}if(kt.index!==null){let E=kt.index.array;if(Et.length>0)for(let x=0;x<Et.length;x++){let B=Et[x];if(Ut=yt===!0?ut.material[B.materialIndex]:ut.material,Ut!==void 0)for(let st=B.start,Q=B.start+B.count;st<Q;st+=3)Mt.pushTriangle(E[st],E[st+1],E[st+2],Ut)}else for(let x=0,B=E.length;x<B;x+=3)Mt.pushTriangle(E[x],E[x+1],E[x+2],Ut)}else if(Et.length>0)for(let E=0;E<Et.length;E++){let x=Et[E];if(Ut=yt===!0?ut.material[x.materialIndex]:ut.material,Ut!==void 0)for(let B=x.start,st=x.start+x.count;B<st;B+=3)Mt.pushTriangle(B,B+1,B+2,Ut)}else for(let E=0,x=Vt.length/3;E<x;E+=3)Mt.pushTriangle(E,E+1,E+2,Ut)}else if(ut.isLine){L.multiplyMatrices(U,m);let Ut=kt.attributes;if(Ut.position!==void 0){let yt=Ut.position.array;for(let Xt=0,Et=yt.length;Xt<Et;Xt+=3)Mt.pushVertex(yt[Xt],yt[Xt+1],yt[Xt+2]);if(Ut.color!==void 0){let Xt=Ut.color.array;for(let Et=0,Vt=Xt.length;Et<Vt;Et+=3)Mt.pushColor(Xt[Et],Xt[Et+1],Xt[Et+2])}if(kt.index!==null){let Xt=kt.index.array;for(let Et=0,Vt=Xt.length;Et<Vt;Et+=2)Mt.pushLine(Xt[Et],Xt[Et+1])}else{let Xt=ut.isLineSegments?2:1;for(let Et=0,Vt=yt.length/3-1;Et<Vt;Et+=Xt)Mt.pushLine(Et,Et+1)}}}else if(ut.isPoints){L.multiplyMatrices(U,m);let Ut=kt.attributes;if(Ut.position!==void 0){let yt=Ut.position.array;for(let Xt=0,Et=yt.length;Xt<Et;Xt+=3)R.set(yt[Xt],yt[Xt+1],yt[Xt+2],1),R.applyMatrix4(L),jt(R,ut,ft)}}else ut.isSprite&&(ut.modelViewMatrix.multiplyMatrices(ft.matrixWorldInverse,ut.matrixWorld),R.set(m.elements[12],m.elements[13],m.elements[14],1),R.applyMatrix4(U),jt(R,ut,ft))}return bt===!0&&C.elements.sort(Ne),C};function jt(K,ft,xt){let bt=1/K.w;K.z*=bt,K.z>=-1&&K.z<=1&&(d=re(),d.id=ft.id,d.x=K.x*bt,d.y=K.y*bt,d.z=K.z,d.renderOrder=ft.renderOrder,d.object=ft,d.rotation=ft.rotation,d.scale.x=ft.scale.x*Math.abs(d.x-(K.x+xt.projectionMatrix.elements[0])/(K.w+xt.projectionMatrix.elements[12])),d.scale.y=ft.scale.y*Math.abs(d.y-(K.y+xt.projectionMatrix.elements[5])/(K.w+xt.projectionMatrix.elements[13])),d.material=ft.material,C.elements.push(d))}function he(){if(e===n){let K=new jf;return X.push(K),n++,e++,K}return X[e++]}function Zt(){if(r===o){let K=new xs;return D.push(K),o++,r++,K}return D[r++]}function fe(){if(l===c){let K=new Fa;return H.push(K),c++,l++,K}return H[l++]}function de(){if(u===f){let K=new Oa;return q.push(K),f++,u++,K}return q[u++]}function re(){if(g===S){let K=new Ba;return G.push(K),S++,g++,K}return G[g++]}function Ne(K,ft){return K.renderOrder!==ft.renderOrder?K.renderOrder-ft.renderOrder:K.z!==ft.z?ft.z-K.z:K.id!==ft.id?K.id-ft.id:0}function Ie(K){p[0]=K[0],p[1]=K[1],p[2]=K[2];let ft=3,xt=0;for(let bt=0;bt<tt.length;bt++){let _t=tt[bt];if(xt=0,ft===0)break;for(let P=0;P<ft;P++){let ut=p[P],kt=p[(P+1)%ft],Ut=_t.sign*ut.z+ut.w,yt=_t.sign*kt.z+kt.w,Xt=Ut>=0,Et=yt>=0;if(Xt&&Et)M[xt++]=ut;else if(Xt&&!Et){M[xt++]=ut;let Vt=Ut/(Ut-yt),E=ct[xt];E||(E=new Ae,ct[xt]=E),E.lerpVectors(ut,kt,Vt),M[xt++]=E}else if(!Xt&&Et){let Vt=Ut/(Ut-yt),E=ct[xt];E||(E=new Ae,ct[xt]=E),E.lerpVectors(ut,kt,Vt),M[xt++]=E}}let Yt=p;p=M,M=Yt,ft=xt}return ft}function Ge(K,ft){let xt=0,bt=1,_t=K.z+K.w,Yt=ft.z+ft.w,P=-K.z+K.w,ut=-ft.z+ft.w;return _t>=0&&Yt>=0&&P>=0&&ut>=0?!0:_t<0&&Yt<0||P<0&&ut<0?!1:(_t<0?xt=Math.max(xt,_t/(_t-Yt)):Yt<0&&(bt=Math.min(bt,_t/(_t-Yt))),P<0?xt=Math.max(xt,P/(P-ut)):ut<0&&(bt=Math.min(bt,P/(P-ut))),bt<xt?!1:(K.lerp(ft,xt),ft.lerp(K,1-bt),!0))}}};var Sh=class{constructor(){let t,e,n,s,r,o,a,l,c,h,u,f=0,d=0,g=0,S=null,m=1,p,M,C=this,v=new po,R=new po,A=new ee,y=new ee,T=new ee,k=new ee,U=new ee,L=new ee,V=new O,X=new O,D=new O,H=new O,q=new oe,G=new ve,ct=new ve,Y=[],j=[],it=[],pt=new vh,ht=document.createElementNS("http://www.w3.org/2000/svg","svg");this.domElement=ht,this.autoClear=!0,this.sortObjects=!0,this.sortElements=!0,this.overdraw=.5,this.outputColorSpace=Vn,this.info={render:{vertices:0,faces:0}},this.setQuality=function(K){switch(K){case"high":m=1;break;case"low":m=0;break}},this.setClearColor=function(K){L.set(K)},this.setPixelRatio=function(){},this.setSize=function(K,ft){s=K,r=ft,o=s/2,a=r/2,ht.setAttribute("viewBox",-o+" "+-a+" "+s+" "+r),ht.setAttribute("width",s),ht.setAttribute("height",r),v.min.set(-o,-a),v.max.set(o,a)},this.getSize=function(){return{width:s,height:r}},this.setPrecision=function(K){S=K};function tt(){for(f=0;ht.childNodes.length>0;)ht.removeChild(ht.childNodes[0])}function gt(K){return S!==null?K.toFixed(S):K}function Mt(K,ft){let xt=K.data.renderOrder!==void 0?K.data.renderOrder:0,bt=ft.data.renderOrder!==void 0?ft.data.renderOrder:0;if(xt!==bt)return xt-bt;{let _t=K.data.z!==void 0?K.data.z:0;return(ft.data.z!==void 0?ft.data.z:0)-_t}}this.clear=function(){tt(),ht.style.backgroundColor=L.getStyle(C.outputColorSpace)},this.render=function(K,ft){if(!(ft instanceof ir)){console.error("THREE.SVGRenderer.render: camera is not an instance of Camera.");return}let xt=K.background;xt&&xt.isColor?(tt(),ht.style.backgroundColor=xt.getStyle(C.outputColorSpace)):this.autoClear===!0&&this.clear(),C.info.render.vertices=0,C.info.render.faces=0,G.copy(ft.matrixWorldInverse),ct.multiplyMatrices(ft.projectionMatrix,G),t=pt.projectScene(K,ft,this.sortObjects,this.sortElements),e=t.elements,n=t.lights,q.getNormalMatrix(ft.matrixWorldInverse),Lt(n),g=0;for(let bt=0,_t=e.length;bt<_t;bt++){let Yt=e[bt],P=Yt.material;P===void 0||P.opacity===0||Ge(g++,"element",Yt,P)}d=0,K.traverseVisible(function(bt){if(bt.isSVGObject){if(V.setFromMatrixPosition(bt.matrixWorld),V.applyMatrix4(ct),V.z<-1||V.z>1)return;let _t=V.x*o,Yt=-V.y*a,P=Ie(d++);P.node=bt.node,P.x=_t,P.y=Yt,P.z=V.z,P.renderOrder=bt.renderOrder,Ge(g++,"svgObject",P,null)}}),it.length=g,this.sortElements&&d>0&&it.sort(Mt),p="",M="";for(let bt=0;bt<g;bt++){let _t=it[bt];if(_t.type==="svgObject"){re();let Yt=_t.data,P=Yt.node;P.setAttribute("transform","translate("+Yt.x+","+Yt.y+")"),ht.appendChild(P)}else{let Yt=_t.data,P=_t.material;R.makeEmpty(),Yt instanceof Ba?(l=Yt,l.x*=o,l.y*=-a,jt(l,Yt,P)):Yt instanceof Oa?(l=Yt.v1,c=Yt.v2,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,R.setFromPoints([l.positionScreen,c.positionScreen]),v.intersectsBox(R)===!0&&he(l,c,P)):Yt instanceof Fa&&(l=Yt.v1,c=Yt.v2,h=Yt.v3,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,h.positionScreen.x*=o,h.positionScreen.y*=-a,this.overdraw>0&&(fe(l.positionScreen,c.positionScreen,this.overdraw),fe(c.positionScreen,h.positionScreen,this.overdraw),fe(h.positionScreen,l.positionScreen,this.overdraw)),R.setFromPoints([l.positionScreen,c.positionScreen,h.positionScreen]),v.intersectsBox(R)===!0&&Zt(l,c,h,Yt,P))}}re()};function Lt(K){T.setRGB(0,0,0),k.setRGB(0,0,0),U.setRGB(0,0,0);for(let ft=0,xt=K.length;ft<xt;ft++){let bt=K[ft],_t=bt.color;bt.isAmbientLight?(T.r+=_t.r,T.g+=_t.g,T.b+=_t.b):bt.isDirectionalLight?(k.r+=_t.r,k.g+=_t.g,k.b+=_t.b):bt.isPointLight&&(U.r+=_t.r,U.g+=_t.g,U.b+=_t.b)}}function At(K,ft,xt,bt){for(let _t=0,Yt=K.length;_t<Yt;_t++){let P=K[_t],ut=P.color;if(P.isDirectionalLight){let kt=V.setFromMatrixPosition(P.matrixWorld).sub(X.setFromMatrixPosition(P.target.matrixWorld)).normalize(),Ut=xt.dot(kt);if(Ut<=0)continue;Ut*=P.intensity,bt.r+=ut.r*Ut,bt.g+=ut.g*Ut,bt.b+=ut.b*Ut}else if(P.isPointLight){let kt=V.setFromMatrixPosition(P.matrixWorld),Ut=xt.dot(V.subVectors(kt,ft).normalize());if(Ut<=0||(Ut*=P.distance==0?1:1-Math.min(ft.distanceTo(kt)/P.distance,1),Ut==0))continue;Ut*=P.intensity,bt.r+=ut.r*Ut,bt.g+=ut.g*Ut,bt.b+=ut.b*Ut}}}function jt(K,ft,xt){let bt=ft.scale.x*o,_t=ft.scale.y*a;xt.isPointsMaterial&&(bt*=xt.size,_t*=xt.size);let Yt="M"+gt(K.x-bt*.5)+","+gt(K.y-_t*.5)+"h"+gt(bt)+"v"+gt(_t)+"h"+gt(-bt)+"z",P="";(xt.isSpriteMaterial||xt.isPointsMaterial)&&(P="fill:"+xt.color.getStyle(C.outputColorSpace)+";fill-opacity:"+xt.opacity),de(P,Yt)}function he(K,ft,xt){let bt="M"+gt(K.positionScreen.x)+","+gt(K.positionScreen.y)+"L"+gt(ft.positionScreen.x)+","+gt(ft.positionScreen.y);if(xt.isLineBasicMaterial){let _t="fill:none;stroke:"+xt.color.getStyle(C.outputColorSpace)+";stroke-opacity:"+xt.opacity+";stroke-width:"+xt.linewidth+";stroke-linecap:"+xt.linecap;xt.isLineDashedMaterial&&(_t=_t+";stroke-dasharray:"+xt.dashSize+","+xt.gapSize),de(_t,bt)}}function Zt(K,ft,xt,bt,_t){C.info.render.vertices+=3,C.info.render.faces++;let Yt="M"+gt(K.positionScreen.x)+","+gt(K.positionScreen.y)+"L"+gt(ft.positionScreen.x)+","+gt(ft.positionScreen.y)+"L"+gt(xt.positionScreen.x)+","+gt(xt.positionScreen.y)+"z",P="";_t.isMeshBasicMaterial?(A.copy(_t.color),_t.vertexColors&&A.multiply(bt.color)):_t.isMeshLambertMaterial||_t.isMeshPhongMaterial||_t.isMeshStandardMaterial?(y.copy(_t.color),_t.vertexColors&&y.multiply(bt.color),A.copy(T),D.copy(K.positionWorld).add(ft.positionWorld).add(xt.positionWorld).divideScalar(3),At(n,D,bt.normalModel,A),A.multiply(y).add(_t.emissive)):_t.isMeshNormalMaterial&&(H.copy(bt.normalModel).applyMatrix3(q).normalize(),A.setRGB(H.x,H.y,H.z).multiplyScalar(.5).addScalar(.5)),_t.wireframe?P="fill:none;stroke:"+A.getStyle(C.outputColorSpace)+";stroke-opacity:"+_t.opacity+";stroke-width:"+_t.wireframeLinewidth+";stroke-linecap:"+_t.wireframeLinecap+";stroke-linejoin:"+_t.wireframeLinejoin:P="fill:"+A.getStyle(C.outputColorSpace)+";fill-opacity:"+_t.opacity,de(P,Yt)}function fe(K,ft,xt){let bt=ft.x-K.x,_t=ft.y-K.y,Yt=bt*bt+_t*_t;if(Yt===0)return;let P=xt/Math.sqrt(Yt);bt*=P,_t*=P,ft.x+=bt,ft.y+=_t,K.x-=bt,K.y-=_t}function de(K,ft){M===K?p+=ft:(re(),M=K,p=ft)}function re(){p&&(u=Ne(f++),u.setAttribute("d",p),u.setAttribute("style",M),ht.appendChild(u)),p="",M=""}function Ne(K){let ft=Y[K];return ft===void 0&&(ft=document.createElementNS("http://www.w3.org/2000/svg","path"),m==0&&ft.setAttribute("shape-rendering","crispEdges"),Y[K]=ft),ft}function Ie(K){let ft=j[K];return ft===void 0&&(ft={node:null,x:0,y:0,z:0,renderOrder:0},j[K]=ft),ft}function Ge(K,ft,xt,bt){let _t=it[K];return _t===void 0?(_t={type:ft,data:xt,material:bt},it[K]=_t,_t):(_t.type=ft,_t.data=xt,_t.material=bt,_t)}}};function S0(i,t,e,n){let s=[],r=[];i.traverseVisible(l=>{l instanceof hs&&r.push(l),((l instanceof us||l instanceof co)&&(l.geometry.getAttribute("position")?.count??0)===0||l instanceof hs||l instanceof _n&&l.geometry.getAttribute("position")===void 0)&&s.push(l)});for(let l of s)l.visible=!1;let o=new Sh;o.setSize(e,n),o.setClearColor(i.background instanceof ee?i.background:new ee("white"),1),o.setPrecision(2),o.render(i,t);for(let l of s)l.visible=!0;let a=o.domElement;a.setAttribute("xmlns","http://www.w3.org/2000/svg");for(let l of r){let c=l.getWorldPosition(new O).project(t),h=document.createElementNS("http://www.w3.org/2000/svg","text");h.textContent=`${l.userData.words}`;let u={x:c.x*e/2,y:-c.y*n/2,"text-anchor":"middle","font-family":"sans-serif","font-size":12,fill:"#64748b"};for(let[f,d]of Object.entries(u))h.setAttribute(f,`${d}`);a.append(h)}return new XMLSerializer().serializeToString(a)}var dE=250,pE=2e3,mE=4,M0=2;function gE(i){let t=i.getExtension("WEBGL_debug_renderer_info"),e=i.getParameter(t?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}var Mh=class{constructor(t){this.redraw=t;let e={alpha:!1,depth:!0,stencil:!1,preserveDrawingBuffer:!0},n=document.createElement("canvas"),s=n.getContext("webgl2",{...e,antialias:!1});s!==null&&gE(s)?(this.software=!0,this.renderer=new Ia({canvas:n,context:s,...e})):(this.software=!1,s?.getExtension("WEBGL_lose_context")?.loseContext(),this.renderer=new Ia({...e,antialias:!0})),this.canvas=this.renderer.domElement,this.fine=!this.software,this.ratio()}redraw;canvas;renderer;software;fine=!0;rest=0;before=0;size(t,e){this.renderer.setSize(t,e)}draw(t,e){this.software&&this.soften(),this.renderer.render(t,e)}soften(){let t=this.rest<0;this.fine!==t&&(this.fine=t,this.ratio()),clearTimeout(this.rest);let e=performance.now(),n=Math.min(Math.max(mE*(e-this.before),dE),pE);this.before=e,this.rest=t?0:setTimeout(()=>{this.rest=-1,this.redraw()},n)}ratio(){let t=Math.min(window.devicePixelRatio,M0);this.renderer.setPixelRatio(this.software?this.fine?M0:Math.min(t,1):t)}};var _E=200,b0=new Set(["trace","ground","rail","track","frame","slider","dial","text"]),xE=new Set(["box","cylinder","cone","disc","sphere","mass","body","circle","mesh"]),w0=13,yE=.05,vE=20,SE=4,Eh=class{constructor(t,e,n,s,r){this.head=t;this.place=r;this.motion=e,this.screen=new Mh(()=>this.render()),this.canvas=this.screen.canvas,this.canvas.setAttribute("role","img"),this.canvas.setAttribute("aria-label",`The machine ${t.name}, moving`),r.append(this.canvas),this.places=bE(t,e),this.box=wh(this.places,e);let{length:o,scales:a,coil:l}=t.stage,c=new O(...t.stage.center);this.sizes={length:o,scales:a,coil:l,center:c,planar:t.planar,first:t.scene.first,forms:s,meshes:n},this.camera=t.planar?new Os:new Gn(35,1,o/100,o*100),this.camera.up.set(...t.stage.axes[1]),this.controls=new xh(this.camera,this.canvas),this.controls.enableRotate=!t.planar,this.controls.addEventListener("change",()=>this.render()),this.controls.addEventListener("start",()=>{this.moved=!0,this.followed=null}),this.scene.add(new ga(16777215,.7),new pa(16777215,9741240,1.2));let h=new ma(16777215,2);h.position.set(.6,1,1.2),this.camera.add(h),this.scene.add(this.camera,this.ghosts),this.furnish(),this.surround(),this.grid=this.ground(o),this.scene.add(this.grid);let u=new Dn;t.planar&&(u.position.z=2*o),this.scene.add(u),this.overlay=t.vectors?new uh(t.vectors,this.sizes,u):null,this.theme(),this.aim(),new ResizeObserver(()=>{(r.clientWidth!==this.canvas.clientWidth||r.clientHeight!==this.canvas.clientHeight)&&this.resize()}).observe(r)}head;place;canvas;screen;scene=new ia;camera;controls;drawn=[];box;sizes;grid;ghosts=new Dn;shown={forces:!0,frames:!1};overlay;moved=!1;posed=!1;onlyGauges=!1;motion;numbers=new Float64Array(0);places;followed=null;furnish(){let t=this.head.scene.shapes.filter(bh),e=this.box.clone();for(let n of this.head.scene.shapes){let s=bh(n)?v0(n,this.sizes,e,this.facing(),t.indexOf(n),t.length):hh(n,this.sizes);s.object.traverse(r=>r.userData.shape=n),this.drawn.push(s),this.scene.add(s.object)}this.onlyGauges=t.length>0&&this.head.scene.shapes.every(n=>bh(n)||b0.has(n.kind)),this.show()}enclose(t){let e=this.drawn.filter(({shape:s})=>xE.has(s.kind)),n=new Float64Array(t.width);for(let s=0;s<w0&&t.count>0;++s){let r=Math.round((t.count-1)*s/(w0-1));t.state(t.at(r,0),n);for(let o of e)o.update({numbers:n,first:this.head.scene.first}),o.object.updateMatrixWorld(!0),o.object.visible&&this.box.expandByObject(o.object)}}follow(t){if(this.motion=t,this.moved||this.onlyGauges||this.followed!==null)return;let e=this.box.clone().expandByScalar(yE*this.sizes.length),n=wh(this.places,t);e.containsBox(n)||n.union(this.box).getSize(new O).length()>vE*this.sizes.length||(this.box.union(n),this.enclose(t),this.aim())}facing(){let[t,e,n]=this.head.stage.axes.map(s=>new O(...s));return new ve().makeBasis(t,e,n)}show(){for(let{object:t,shape:e}of this.drawn)e.kind==="frame"&&(t.visible=this.shown.frames),(e.kind==="force"||e.kind==="torque")&&(t.visible=this.shown.forces)}ground(t){let e=10**Math.floor(Math.log10(t/2)),n=2*Math.ceil(1.5*t/e),s=new xa(n*e,n),r=this.box.getCenter(new O);this.head.planar?s.rotation.x=Math.PI/2:s.quaternion.setFromUnitVectors(new O(0,1,0),new O(...this.head.stage.axes[1]));let o=new O(...this.head.stage.axes[1]);if(this.head.planar)s.position.set(E0(r.x,e),E0(r.y,e),-.2*t);else{let a=Math.min(o.dot(this.box.min),o.dot(this.box.max));s.position.copy(r).addScaledVector(o,a-o.dot(r)-.02*t)}return s}lookAt(){this.moved=!1;let t=this.followed===null?this.machineAt(this.numbers):null;this.followed=t!==null&&this.drivesAway(t)?t.getCenter(new O):null,t!==null&&this.followed!==null?this.box.copy(t.expandByScalar(.2*t.getSize(new O).length())):this.surround(),this.aim()}machineAt(t){return T0(new Yn,this.places,e=>t[e])}drivesAway(t){let e=t.getSize(new O).length();return e>0&&wh(this.places,this.motion).getSize(new O).length()>SE*e}go(){if(this.followed===null)return;let t=this.machineAt(this.numbers).getCenter(new O),e=t.clone().sub(this.followed);this.followed=t,this.box.translate(e),this.camera.position.add(e),this.controls.target.add(e),this.controls.update()}surround(){this.onlyGauges?this.box.makeEmpty():(this.box.copy(wh(this.places,this.motion)),this.enclose(this.motion));for(let{object:t,shape:e}of this.drawn)bh(e)&&this.box.expandByObject(t)}aim(){let t=this.box.getSize(new O).length()/Math.SQRT2;this.grid.scale.setScalar(Math.max(Lr(.8*t/this.sizes.length),1)),this.controls.target.copy(this.box.getCenter(new O)),this.resize(),this.controls.update()}fit(t){let e=this.box.getCenter(new O),{length:n}=this.sizes;if(this.camera instanceof Os){let h=this.box.getSize(new O),u=.12*Math.max(h.x,h.y,.2*n),f=Math.max(h.y/2+u,(h.x/2+u)/t);if(Object.assign(this.camera,{top:f,bottom:-f,right:f*t,left:-f*t}),this.moved)return;Object.assign(this.camera,{near:.1*n,far:30*n,zoom:1}),this.camera.position.copy(e).add(new O(0,0,10*n));return}if(this.camera.aspect=t,this.moved)return;let s=this.facing(),r=new O(0,.38,.92).transformDirection(s),o=new O().setFromMatrixColumn(s,0),a=new O().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360)/1.12,c=0;for(let h=0;h<8;++h){let u=new O(...[0,1,2].map(d=>(h>>d&1?this.box.max:this.box.min).getComponent(d)));u.sub(e);let f=Math.max(Math.abs(u.dot(o))/t,Math.abs(u.dot(a)));c=Math.max(c,u.dot(r)+f/l)}this.camera.position.copy(e).addScaledVector(r,Math.max(c,.5*n))}resize(){let{clientWidth:t,clientHeight:e}=this.place;t===0||e===0||(this.screen.size(t,e),this.fit(t/e),this.camera.updateProjectionMatrix(),this.controls.update(),this.render())}theme(){let t=getComputedStyle(document.documentElement);this.scene.background=new ee(t.getPropertyValue("--stage").trim());let e=new ee(t.getPropertyValue("--grid").trim());for(let n of[this.grid.material].flat())n.vertexColors=!1,n.color=e,n.needsUpdate=!0;this.render()}pose(t,e,n){this.posed=!0,this.numbers=e,this.go();let s={numbers:e,first:this.head.scene.first},r=t.rowAt(n);for(let o of this.drawn)o.follow?.(t,r),o.update(s),o.object.updateMatrixWorld(!0);this.overlay?.pose(n),this.render()}postures(t,e){this.ghosts.clear();let n=new Float64Array(t.width);for(let s of e){t.state(s,n);for(let r of this.drawn){if(b0.has(r.shape.kind)||(r.update({numbers:n,first:this.head.scene.first}),!r.object.visible))continue;let o=r.object.clone();o.traverse(a=>{if(!(a instanceof _n))return;let l=a.material.clone();Object.assign(l,{transparent:!0,opacity:.22,depthWrite:!1}),a.material=l,a.userData.bent&&(a.geometry=a.geometry.clone())}),this.ghosts.add(o)}}this.ghosts.updateMatrixWorld(!0)}sketch(){return S0(this.scene,this.camera,this.place.clientWidth,this.place.clientHeight)}render(){this.posed&&this.screen.draw(this.scene,this.camera)}shapeAt(t,e){let n=this.canvas.getBoundingClientRect(),s=new Kt((t-n.left)/n.width*2-1,1-(e-n.top)/n.height*2),r=new _a;r.setFromCamera(s,this.camera);let o=[...this.drawn,...this.overlay?.drawn??[]].filter(l=>l.object.visible);return r.intersectObjects(o.map(l=>l.object)).find(l=>l.object.visible)?.object.userData.shape??null}value(t,e){if(this.overlay?.drawn.some(s=>s.shape===t))return this.overlay.value(t);if(t.kind!=="force"&&t.kind!=="torque")return"";let n=ci(t.numbers,"vector",{numbers:e,first:this.head.scene.first}).length();return`${Ua(n)} ${So(t)}`}highlight(t){for(let e of[...this.drawn,...this.overlay?.drawn??[]])e.object.traverse(n=>{n instanceof _n&&n.material instanceof ds&&n.material.emissive.setHex(t.includes(e.shape)?8016384:0)});this.render()}};function bh(i){return i.kind==="slider"||i.kind==="dial"}function E0(i,t){return Math.round(i/t)*t}function ME(i,t,e){if(e.count===0)return 0;let s=t.parts.flatMap(({sizes:r})=>r??[]).filter(([,r,o])=>r>=0&&!o).map(([r,o])=>Math.abs(r*e.at(0,i.scene.first+o)));return Math.max(0,...s.filter(Number.isFinite))}function bE(i,t){return i.scene.shapes.filter(({kind:e})=>e!=="frame").flatMap(e=>{let n=ME(i,e,t),r=e.parts.filter(({still:o})=>!o).flatMap(({numbers:o})=>["at","to"].flatMap(a=>o[a]??[]));return[...new Set(r)].map(o=>({column:i.scene.first+o,radius:n}))})}function T0(i,t,e){let n=new O;for(let{column:s,radius:r}of t)n.set(e(s),e(s+1),e(s+2)),Number.isFinite(n.x+n.y+n.z)&&i.expandByPoint(n.clone().addScalar(r)).expandByPoint(n.clone().addScalar(-r));return i}function wh(i,t){let e=new Yn,n=Math.max(1,Math.floor(t.count/_E));for(let r=0;r<t.count;r+=n)T0(e,i,o=>t.at(r,o));return e.isEmpty()&&e.set(new O(0,0,0),new O(0,0,0)),e.getSize(new O).length()===0&&e.expandByScalar(.5),e}function A0(i){let t=[...document.querySelectorAll("[role=tab]")],e=n=>{for(let s of t)s.ariaSelected=`${s===n}`,s.tabIndex=s===n?0:-1,document.getElementById(s.getAttribute("aria-controls")??"")?.toggleAttribute("hidden",s!==n);i()};t.forEach((n,s)=>{n.onclick=()=>e(n),n.onkeydown=r=>{let o=r.key==="ArrowRight"?1:r.key==="ArrowLeft"?-1:0;if(o===0)return;r.stopPropagation();let a=t[(s+o+t.length)%t.length];e(a),a.focus()}}),e(t[0])}var Th=class{terms;pinned=null;constructor(t,e,n,s){this.terms=[...e.querySelectorAll("[data-from]")].map(r=>{let a=(r.getAttribute("data-from")??"").split(" ").filter(l=>l!=="").map(l=>t.sources[Number(l)]).filter(l=>l!==null);return{element:r,spans:a}});for(let{element:r,spans:o}of this.terms)r.addEventListener("pointerenter",()=>{this.mark(null),r.classList.add("marked"),n(o)}),r.addEventListener("pointerleave",()=>{this.mark(null),n([])}),r.addEventListener("click",()=>s(o))}first(t){return this.terms.find(({spans:e})=>e.some(n=>Ah(n,t)))?.element??null}pin(t){this.pinned=t,this.mark(null)}mark(t){let e=[t,this.pinned].filter(n=>n!==null);for(let{element:n,spans:s}of this.terms)n.classList.toggle("marked",s.some(r=>e.some(o=>Ah(r,o))))}};function Ah(i,t){return C0(i.first,t.last)&&C0(t.first,i.last)}function C0(i,t){return i[0]<t[0]||i[0]===t[0]&&i[1]<t[1]}function Qf(i){return(t,e,n)=>{let s=document.createElement("button");return s.textContent=t,s.title=e,s.onclick=n,i.append(s),s}}function R0(i,t){let e=document.createElement("details");e.className="menu";let n=document.createElement("summary");n.textContent=t;let s=document.createElement("div");return s.onclick=()=>e.open=!1,e.append(n,s),i.append(e),document.addEventListener("pointerdown",r=>{r.target instanceof Node&&e.contains(r.target)||(e.open=!1)}),s}var P0=601,I0=5,Ch=72,EE=480,TE=500,L0="Keys: space play and pause, arrows step, Home and End, + and - speed, g ghosts, v velocities, f the whole machine";function Ke(i){let t=document.getElementById(i);if(t===null)throw new Error(`the page has no #${i}`);return t}var td=class{constructor(t,e,n){this.head=t;this.motions=e;this.stage=n;let[s]=e;this.motion=s,this.numbers=new Float64Array(s.width),this.player=new fh(t,Ke("player"),o=>this.pose(o)),this.sliders=new mh(t,xu(e),Ke("sliders"),()=>this.again()),this.curves=new ll(t,s,Ke("curves"),o=>this.player.go(o)),this.source=new gh(t,Ke("source"),o=>this.follow(o),o=>this.toTerms(o)),this.terms=new Th(t,Ke("derivation"),o=>this.mark(o),o=>this.toSource(o)),this.cells=this.values();let r=Ke("units");r.onchange=()=>Ke("derivation").classList.toggle("units",r.checked),A0(()=>{this.tell(),this.source.pin([]),this.terms.pin(null)}),this.tools(),this.keys(),this.pointer(),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.stage.theme()),this.say(t.said),this.pose(t.start),this.tell(),window.addEventListener("beforeprint",()=>this.tell()),t.modes!==void 0&&(Ke("sliders-tab").textContent="Modes"),new dh(t,Ke("sliders"),o=>this.choose(o)),e.length>1&&t.modes===void 0&&this.curves.behind(e)}head;motions;stage;motion;numbers;player;sliders;curves;source;terms;cells;live=null;ghosts=!1;arrows=null;endFilm=null;ghostly=null;speedy=null;async begin(){this.live=await zo.begin(this.head,P0,t=>this.arrived(t));for(let t of Ke("sliders").querySelectorAll(":scope > :not(#runs)"))t.toggleAttribute("inert",this.live===null),t.hidden=this.head.live===!1;this.live===null&&this.head.live!==!1&&this.say("This browser shows the recorded motion only: sliders need WebAssembly."),document.documentElement.dataset.ready=this.live===null?"recorded":"live",matchMedia("(prefers-reduced-motion: reduce)").matches||this.player.play()}choose(t){let e=this.head.runs?.[t];e!==void 0&&(this.motion=this.motions[t],this.player.over(e.start,e.stop,e.pace),this.player.mark(e.events),this.curves.show(this.motion,e.events),e.parameters!==null&&this.sliders.take(e.parameters),this.say(e.said===""?e.label:`${e.label}: ${e.said}`),this.stage.follow(this.motion),this.haunt(),this.pose(this.player.time),e.parameters!==null&&e.said===""&&this.again())}haunt(){let{last:t}=this.motion,e=this.motion.count>0?this.motion.at(0,0):0,n=Array.from({length:I0},(s,r)=>e+(t-e)*r/(I0-1));this.stage.postures(this.motion,this.ghosts?n:[])}pose(t){let e=Math.min(t,this.motion.last);this.motion.state(e,this.numbers),this.stage.pose(this.motion,this.numbers,e),this.legend(),this.curves.point(e),Ke("table-panel").hidden||this.tell()}tell(){this.cells.forEach((t,e)=>t.textContent=Zf(this.head.columns[e],this.numbers[e]))}again(){this.live?.run(this.sliders.parameters,this.sliders.inputs),this.arrows?.then(t=>t?.run(this.sliders.parameters,this.sliders.inputs))}async point(t,e){let n=this.stage.overlay;if(n!==null){if(e?n.shown.add(t):n.shown.delete(t),e&&this.arrows===null){let s=({motion:r})=>{n.take(r),document.documentElement.dataset.arrows=`${r.count}`,this.pose(this.player.time)};this.arrows=zo.begin(this.head,P0,s,"vectors"),await this.arrows===null&&this.say("Arrows need WebAssembly."),this.again()}this.pose(this.player.time)}}mark(t){let e=this.head.scene.shapes.filter(({span:n})=>n!==null&&t.some(s=>Ah(s,n)));this.stage.highlight(e),this.source.mark(t),Ke("pointed").textContent=e.map(n=>n.name).join(", ")}follow(t){this.mark(t===null?[]:[t]),this.terms.mark(t)}toSource(t){Ke("source-tab").click(),this.source.pin(t)}toTerms(t){let e=this.terms.first(t);if(e===null){this.say("No term of the equations comes from this line.");return}Ke("derivation-tab").click(),this.terms.pin(t),e.scrollIntoView({block:"center"})}fit(){this.stage.lookAt(),this.pose(this.player.time)}legend(){let t=(this.stage.overlay?.legend()??[]).join(`
`),e=Ke("legend");e.textContent!==t&&(e.textContent=t)}arrived({motion:t,status:e,time:n,took:s}){t.count>0&&(this.motion=t,this.curves.show(t),this.player.mark([]),this.stage.follow(t),this.haunt(),this.pose(this.player.time)),document.documentElement.dataset.took=s.toFixed(2),e===0?this.say(`Integrated anew in ${s.toFixed(1)} ms.`):e===-1?this.say(`This motion takes long; it is shown up to ${n.toPrecision(4)} s.`):this.say(`${this.head.words[e]??`The run ended with status ${e}.`} (t = ${n.toPrecision(5)} s)`)}say(t){Ke("said").textContent=t}values(){let t=Ke("values");return this.head.columns.slice(0,this.head.scene.first).map(e=>{let n=document.createElement("tr"),s=document.createElement("th");s.scope="row",s.textContent=e.name;let r=document.createElement("td"),o=document.createElement("td");return o.textContent=e.display.unit,n.append(s,r,o),t.append(n),r})}tools(){let t=Qf(Ke("tools")),e=(n,s)=>{let r=t(n,s,()=>{this.stage.shown[n]=!this.stage.shown[n],r.ariaPressed=`${this.stage.shown[n]}`,this.stage.show(),this.pose(this.player.time)});r.ariaPressed=`${this.stage.shown[n]}`};this.head.scene.shapes.some(({kind:n})=>n==="force"||n==="torque")&&e("forces","Arrows of loads"),this.switches(t),this.head.scene.shapes.some(({kind:n})=>n==="frame")&&e("frames","Axes of frames"),this.ghostly=t("ghosts","Pale postures of several instants (key g)",()=>this.toggleGhosts()),this.ghostly.ariaPressed="false",t("fit","The whole machine (key f)",()=>this.fit()),t("keys",L0,()=>this.say(L0)),this.saving()}saving(){let t=Qf(R0(Ke("tools"),"save"));if(t("PNG","The picture",()=>Jp(this.stage.canvas,this.head)),t("SVG","The picture as lines and faces",()=>Dr(new Blob([this.stage.sketch()],{type:"image/svg+xml"}),`${this.head.name}.svg`)),t("GIF","The motion as a film that plays everywhere",()=>{this.filmed()}),t("CSV","The values",()=>Kp(this.motion,this.head)),typeof MediaRecorder>"u")return;let e=t("film","Record what plays",()=>{this.endFilm===null?(this.endFilm=jp(this.stage.canvas,this.head),this.player.play()):(this.endFilm(),this.endFilm=null),e.ariaPressed=`${this.endFilm!==null}`})}switches(t){let e=this.stage.overlay;if(e===null)return;for(let[s,r,o]of d0){if(!e.has(s))continue;let a=t(r,o,()=>{let l=!e.shown.has(s);a.ariaPressed=`${l}`,this.point(s,l),s==="admissible"&&(n.hidden=!l)});a.ariaPressed="false",s==="velocity"&&(this.speedy=a)}let n=document.createElement("select");n.title="The coordinate that moves",n.ariaLabel=n.title,n.hidden=!0,n.append(new Option("all coordinates",""),...e.coordinates.map(s=>new Option(s,s))),n.onchange=()=>{e.coordinate=n.value,this.pose(this.player.time)},Ke("tools").append(n)}toggleGhosts(){this.ghosts=!this.ghosts,this.ghostly!==null&&(this.ghostly.ariaPressed=`${this.ghosts}`),this.haunt(),this.pose(this.player.time)}async filmed(){this.player.pause();let{canvas:t}=this.stage,e=document.createElement("canvas");e.width=Math.min(EE,t.width),e.height=Math.round(e.width*t.height/t.width);let n=e.getContext("2d",{willReadFrequently:!0});if(n===null)return;let{time:s}=this.player,r=this.motion.at(0,0),o=this.motion.last-r,a=[];for(let c=0;c<Ch;++c)this.pose(r+o*c/(Ch-1)),n.drawImage(t,0,0,e.width,e.height),a.push(n.getImageData(0,0,e.width,e.height)),c%8===0&&(this.say(`Film: ${c+1} of ${Ch} pictures`),await new Promise(h=>setTimeout(h)));let l=Math.min(Math.max(o,3),10);Dr(Qp(a,1e3*l/Ch),`${this.head.name}.gif`),this.say("The film is saved."),this.pose(s)}keys(){document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.target instanceof HTMLInputElement||t.target instanceof HTMLSelectElement)return;let n={" ":()=>this.player.toggle(),ArrowRight:()=>this.player.step(.01),ArrowLeft:()=>this.player.step(-.01),"+":()=>this.player.faster(1),"-":()=>this.player.faster(-1),g:()=>this.toggleGhosts(),v:()=>this.speedy?.click(),f:()=>this.fit(),Home:()=>this.player.go(-1/0),End:()=>this.player.go(1/0)}[t.key];n===void 0||t.key===" "&&t.target instanceof HTMLButtonElement||(t.preventDefault(),n())})}pointer(){let t=null;this.stage.canvas.addEventListener("pointermove",e=>{if(e.buttons!==0)return;let n=this.stage.shapeAt(e.clientX,e.clientY);if(n===t)return;t=n,this.stage.highlight(n===null?[]:[n]),this.source.mark(n?.span?[n.span]:[]),this.terms.mark(n?.span??null);let s=n===null?"":this.stage.value(n,this.numbers);Ke("pointed").textContent=[n?.name??"",s].filter(r=>r!=="").join(": ")})}};function AE(){return new Promise(i=>{requestAnimationFrame(()=>setTimeout(i)),setTimeout(i,TE)})}async function CE(){let i=em(),t=await Promise.all(i.meshes.map(kf)),e=nm(i,await Nr("motion")),n=Object.entries(i.stage.forms).map(async([o,a])=>[o,await kf(a)]),s=new Eh(i,xu(e),t,new Map(await Promise.all(n)),Ke("stage")),[r]=e;s.pose(r,r.state(i.start,new Float64Array(r.width)),i.start),await AE(),await new td(i,e,s).begin()}CE().catch(i=>{Ke("said").textContent=`The page cannot be shown: ${String(i)}`});})();
